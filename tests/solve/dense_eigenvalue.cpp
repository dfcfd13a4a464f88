#include "tests/solve/dense_eigenvalue.h"

#include <Eigen/Dense>

#include "energy/strut_energy.h"
#include "solve/reference_solver.h"
#include "tests/solve/dense_hessian.h"

namespace morphgrid {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;

/// Columns span all motions that do not count.
MatrixXd excludedMotions(const Eigen::Matrix3Xd& positions, Motions motions) {
  const bool inPlane = motions == Motions::inPlane;
  const Eigen::Index count = positions.cols();
  MatrixXd excluded = MatrixXd::Zero(3 * count, 6 + (inPlane ? count : 0));
  for (Eigen::Index n = 0; n < count; ++n) {
    for (int axis = 0; axis < 3; ++axis) {
      const Vector3d unit = Vector3d::Unit(axis);
      const bool counts = inPlane && axis != 2;
      excluded.block<3, 1>(3 * n, axis) = unit;
      excluded.block<3, 1>(3 * n, 3 + axis) =
          counts ? Vector3d::Zero() : Vector3d(unit.cross(positions.col(n)));
    }
    if (inPlane) {
      excluded(3 * n + 2, 6 + n) = 1;
    }
  }
  return excluded;
}

}  // namespace

double denseSmallestEigenvalue(const StrutGrid& grid, Motions motions) {
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(excludedMotions(grid.positions, motions));
  const MatrixXd all = qr.householderQ();
  const MatrixXd allowed = all.rightCols(all.cols() - qr.rank());
  const MatrixXd projected = allowed.transpose() * denseExactHessian(grid) * allowed;
  return Eigen::SelfAdjointEigenSolver<MatrixXd>(projected).eigenvalues()[0] /
         StrutEnergy(grid).meanStiffness();
}

StrutGrid tightRimmedSheet(const GridShape& shape, double shrink) {
  constexpr double kLayerSpacing = 0.1;
  StrutGrid grid{
      shape, 1.0, Eigen::Matrix3Xd(3, shape.vertexCount()), StrutValues(shape), StrutValues(shape),
      {}};
  for (int n = 0; n < shape.vertexCount(); ++n) {
    const int inLayer = n % shape.layerVertexCount();
    grid.positions.col(n) = Vector3d(inLayer % shape.verticesU, inLayer / shape.verticesU,
                                     kLayerSpacing * (n / shape.layerVertexCount()));
  }
  const Vector3d middle(0.5 * (shape.verticesU - 1), 0.5 * (shape.verticesV - 1), 0);
  forEachStrut(shape, [&](const Strut& strut) {
    const Vector3d centre = (grid.positions.col(strut.from) + grid.positions.col(strut.to)) / 2;
    const double rim = ((centre - middle).cwiseQuotient(Vector3d(middle.x(), middle.y(), 1)))
                           .head<2>()
                           .cwiseAbs()
                           .maxCoeff();
    const bool vertical = strut.direction == Strut::Direction::w;
    valueAt(grid.rest, strut) = vertical ? kLayerSpacing : 1 - shrink * rim * rim;
    valueAt(grid.stiffness, strut) = vertical ? 40 : 5;
  });
  return grid;
}

StrutGrid atRest(StrutGrid grid) {
  grid.positions = solveReference(grid, {.tolerance = 1e-12}).positions;
  return grid;
}

}  // namespace morphgrid
