#include "report/figures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/bounding_diagonal.h"
#include "core/rigid_alignment.h"
#include "solve/energy.h"
#include "surface/closest_point.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;

double meanAngleErrorPercent(const GridShape& shape, const Matrix3Xd& x) {
  double sum = 0;
  const std::vector<Corner> corners = listCorners(shape);
  for (const Corner& corner : corners) {
    const Eigen::Vector3d a = x.col(corner.a) - x.col(corner.apex);
    const Eigen::Vector3d b = x.col(corner.b) - x.col(corner.apex);
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    sum += std::abs(angle / (std::numbers::pi / 2) - 1);
  }
  return 100 * sum / static_cast<double>(corners.size());
}

double rootMeanSquare(const Eigen::VectorXd& values) {
  return std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

/// Relative length errors on the layers that carry L0 and L_b, summed over struts.
class LateralErrors {
 public:
  LateralErrors(const StrutGrid& grid, const Matrix3Xd& positions)
      : grid_(grid), positions_(positions) {}

  void add(int i, int j, int toI, int toJ, const std::vector<double>& rest, double bendAngle) {
    const int top = grid_.shape.layers - 1;
    const int convex = bendAngle > 0 ? 0 : top;
    l0_ += relativeError(i, j, toI, toJ, convex, rest);
    lb_ += relativeError(i, j, toI, toJ, top - convex, rest);
    ++count_;
  }
  double l0Percent() const { return 100 * l0_ / count_; }
  double lbPercent() const { return 100 * lb_ / count_; }

 private:
  double relativeError(int i, int j, int toI, int toJ, int layer,
                       const std::vector<double>& rest) const {
    const int from = grid_.shape.index(i, j, layer);
    const int to = grid_.shape.index(toI, toJ, layer);
    const double length = (positions_.col(to) - positions_.col(from)).norm();
    return std::abs(length - rest[from]) / rest[from];
  }

  const StrutGrid& grid_;
  const Matrix3Xd& positions_;
  double l0_ = 0;
  double lb_ = 0;
  int count_ = 0;
};

}  // namespace

StrutErrors computeStrutErrors(const GridDesign& design, const StrutGrid& grid,
                               const Matrix3Xd& positions) {
  LateralErrors errors(grid, positions);
  for (int j = 0; j <= design.nodesV; ++j) {
    for (int i = 0; i < design.nodesU; ++i) {
      errors.add(i, j, i + 1, j, grid.rest.u, design.bendAngles.u(i, j));
    }
  }
  for (int j = 0; j < design.nodesV; ++j) {
    for (int i = 0; i <= design.nodesU; ++i) {
      errors.add(i, j, i, j + 1, grid.rest.v, design.bendAngles.v(i, j));
    }
  }
  return {errors.l0Percent(), errors.lbPercent(), meanAngleErrorPercent(grid.shape, positions)};
}

TargetDistance computeTargetDistance(const Matrix3Xd& middle, const Matrix3Xd& targets,
                                     const ClosestPointQuery& closestPoints) {
  const Matrix3Xd aligned = alignRigidly(middle, targets) * middle;
  const double diagonal = boundingDiagonal(targets);
  const Eigen::VectorXd parametric = 100 / diagonal * (aligned - targets).colwise().norm();
  Eigen::VectorXd closest(aligned.cols());
  for (Eigen::Index n = 0; n < aligned.cols(); ++n) {
    closest[n] = 100 / diagonal * closestPoints.distance(aligned.col(n));
  }
  return {rootMeanSquare(parametric), parametric.maxCoeff(), rootMeanSquare(closest),
          closest.maxCoeff(),         spreadOf(parametric),  spreadOf(closest)};
}

}  // namespace morphgrid
