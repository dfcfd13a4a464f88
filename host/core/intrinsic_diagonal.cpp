#include "core/intrinsic_diagonal.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace morphgrid {
namespace {

using Eigen::Matrix2Xd;
using Eigen::Matrix3Xd;
using Eigen::Vector2d;

/// Turned so that rows are along the axes of inertia, from that of least spread on.
Matrix3Xd alongAxesOfInertia(const Matrix3Xd& points) {
  const Matrix3Xd centred = points.colwise() - points.rowwise().mean();
  const Eigen::Matrix3d moments = centred * centred.transpose();
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(moments);
  return solver.eigenvectors().transpose() * centred;
}

double extentOf(const Eigen::RowVectorXd& values) { return values.maxCoeff() - values.minCoeff(); }

/// Adds a point to a chain of corners that turns left.
void extendChain(std::vector<Vector2d>& chain, std::size_t start, const Vector2d& point) {
  const auto turnsLeft = [&] {
    const Vector2d last = chain.back() - chain[chain.size() - 2];
    const Vector2d next = point - chain.back();
    return last.x() * next.y() - last.y() * next.x() > 0;
  };
  while (chain.size() > start + 1 && !turnsLeft()) chain.pop_back();
  chain.push_back(point);
}

/// The corners of the convex hull, by Andrew's monotone chain: along below, then back above. The
/// first corner is the last one, too.
Matrix2Xd outlineOf(const Matrix2Xd& points) {
  std::vector<Vector2d> sorted(points.colwise().begin(), points.colwise().end());
  std::ranges::sort(sorted, [](const Vector2d& a, const Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  });
  std::vector<Vector2d> chain;
  for (const Vector2d& point : sorted) extendChain(chain, 0, point);
  const std::size_t start = chain.size() - 1;
  for (auto point = sorted.rbegin(); point != sorted.rend(); ++point) {
    extendChain(chain, start, *point);
  }
  Matrix2Xd corners(2, static_cast<Eigen::Index>(chain.size()));
  for (Eigen::Index n = 0; n < corners.cols(); ++n) corners.col(n) = chain[n];
  return corners;
}

/// Of the rectangles around points that have a side along an edge of their outline.
double leastSquaredDiagonal(const Matrix2Xd& points) {
  const Matrix2Xd corners = outlineOf(points);
  double least = std::numeric_limits<double>::infinity();
  for (Eigen::Index n = 1; n < corners.cols(); ++n) {
    const Vector2d edge = corners.col(n) - corners.col(n - 1);
    if (edge.isZero(0)) continue;
    const Vector2d along = edge.normalized();
    const double length = extentOf(along.transpose() * corners);
    const double width = extentOf(along.unitOrthogonal().transpose() * corners);
    least = std::min(least, length * length + width * width);
  }
  return std::isfinite(least) ? least : 0;  // All points are one.
}

}  // namespace

double intrinsicDiagonal(const Matrix3Xd& points) {
  const Matrix3Xd turned = alongAxesOfInertia(points);
  const double thickness = extentOf(turned.row(0));
  return std::sqrt(thickness * thickness + leastSquaredDiagonal(turned.bottomRows<2>()));
}

}  // namespace morphgrid
