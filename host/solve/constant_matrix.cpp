#include "solve/constant_matrix.h"

namespace morphgrid {

ConstantMatrix::ConstantMatrix(const StrutGrid& grid, const StrutEnergy& energy) {
  std::vector<Eigen::Triplet<double>> entries;
  const auto connect = [&](int a, int b, double weight) {
    entries.emplace_back(a, a, 2 * weight);
    entries.emplace_back(b, b, 2 * weight);
    entries.emplace_back(a, b, -2 * weight);
    entries.emplace_back(b, a, -2 * weight);
  };
  for (const Strut& strut : energy.struts()) {
    connect(strut.from, strut.to, valueAt(grid.stiffness, strut));
  }
  for (const Corner& corner : energy.corners()) {
    connect(corner.apex, corner.a, grid.angleWeight);
    connect(corner.apex, corner.b, grid.angleWeight);
  }
  // Translations leave the energy unchanged; a weak hold on one vertex makes the matrix definite.
  entries.emplace_back(0, 0, 1e-6 * energy.constraintWeights().mean());
  const int count = grid.shape.vertexCount();
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  factor_.compute(matrix);
}

Eigen::Matrix3Xd ConstantMatrix::solve(const Eigen::Matrix3Xd& right) const {
  const Eigen::MatrixXd transposed = right.transpose();
  return factor_.solve(transposed).transpose();
}

}  // namespace morphgrid
