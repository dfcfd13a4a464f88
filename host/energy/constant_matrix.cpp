#include "energy/constant_matrix.h"

#include <vector>

#include "energy/energy_terms.h"

namespace morphgrid {

ConstantMatrix::ConstantMatrix(const StrutGrid& grid) {
  std::vector<Eigen::Triplet<double>> entries;
  forEachTerm(grid, [&](const auto& term, const auto& stencil) {
    const double weight = 2 * term.projectionWeight();
    for (const Edge& edge : stencil) {
      entries.emplace_back(edge.from, edge.from, weight);
      entries.emplace_back(edge.to, edge.to, weight);
      entries.emplace_back(edge.from, edge.to, -weight);
      entries.emplace_back(edge.to, edge.from, -weight);
    }
  });
  const int count = grid.shape.vertexCount();
  Eigen::SparseMatrix<double> matrix(count, count);
  matrix.setFromTriplets(entries.begin(), entries.end());
  // Translations leave the energy unchanged; a weak hold on one vertex makes the matrix definite.
  matrix.coeffRef(0, 0) += 0.5e-6 * matrix.diagonal().mean();
  factor_.compute(matrix);
}

Eigen::Matrix3Xd ConstantMatrix::solve(const Eigen::Matrix3Xd& right) const {
  const Eigen::MatrixXd transposed = right.transpose();
  return factor_.solve(transposed).transpose();
}

}  // namespace morphgrid
