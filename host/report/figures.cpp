#include "report/figures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/bounding_diagonal.h"
#include "core/intrinsic_diagonal.h"
#include "core/rigid_alignment.h"
#include "surface/closest_point.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;

double meanAngleErrorPercent(const GridShape& shape, const Matrix3Xd& x) {
  double sum = 0;
  int count = 0;
  forEachCorner(shape, [&](const Corner& corner) {
    const Eigen::Vector3d a = x.col(corner.a) - x.col(corner.apex);
    const Eigen::Vector3d b = x.col(corner.b) - x.col(corner.apex);
    const double angle = std::atan2(a.cross(b).norm(), a.dot(b));
    sum += std::abs(angle / (std::numbers::pi / 2) - 1);
    ++count;
  });
  return 100 * sum / count;
}

double rootMeanSquare(const Eigen::VectorXd& values) {
  return std::sqrt(values.squaredNorm() / static_cast<double>(values.size()));
}

}  // namespace

StrutErrors computeStrutErrors(const GridDesign& design, const StrutGrid& grid,
                               const Matrix3Xd& positions) {
  const int top = grid.shape.layers - 1;
  double l0 = 0;
  double lb = 0;
  int count = 0;
  forEachLateralStrut(grid.shape, [&](const Strut& strut) {
    const int convex = design.bendAngles.at(strut) > 0 ? 0 : top;
    const double rest = valueAt(grid.rest, strut);
    const double error = std::abs(lengthAt(positions, strut) - rest) / rest;
    if (strut.layer == convex) {
      l0 += error;
      ++count;
    }
    if (strut.layer == top - convex) {
      lb += error;
    }
  });
  return {100 * l0 / count, 100 * lb / count, meanAngleErrorPercent(grid.shape, positions)};
}

TargetDistance computeTargetDistance(const Matrix3Xd& middle, const Matrix3Xd& targets,
                                     const ClosestPointQuery* closestPoints) {
  const Matrix3Xd aligned = alignRigidly(middle, targets) * middle;
  const double diagonal = intrinsicDiagonal(targets);
  const Eigen::VectorXd parametric = 100 / diagonal * (aligned - targets).colwise().norm();
  TargetDistance distance{rootMeanSquare(parametric),
                          parametric.maxCoeff(),
                          spreadOf(parametric),
                          std::nullopt,
                          diagonal,
                          boundingDiagonal(targets)};
  if (closestPoints) {
    const Eigen::VectorXd closest = 100 / diagonal * closestPoints->distances(aligned);
    distance.closest = {rootMeanSquare(closest), closest.maxCoeff(), spreadOf(closest)};
  }
  return distance;
}

}  // namespace morphgrid
