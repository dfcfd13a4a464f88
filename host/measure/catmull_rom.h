#pragma once
#include <Eigen/Core>

namespace morphgrid {

/// A Catmull-Rom spline through points: Hermite segments with central tangents
/// (rho_{k+1} - rho_{k-1}) / 2, at the ends one-sided ones of second order,
/// +-(-3 rho_0 + 4 rho_1 - rho_2) / 2, each as a cubic Bezier curve. Two points: their chord.
///
/// Through points h apart on a smooth curve, the curvature of a sample is of first order in h. The
/// mean over a segment is of second order, because the errors of its two halves cancel; in the
/// first and the last segment, whose tangents are unlike, it stays of first order.
class CatmullRomSpline {
 public:
  /// points 3 x n, n >= 2, finite.
  explicit CatmullRomSpline(Eigen::Matrix3Xd points);

  int segmentCount() const { return static_cast<int>(points_.cols()) - 1; }

  /// The four control points of a segment, 3 x 4.
  Eigen::Matrix<double, 3, 4> bezierSegment(int segment) const;

  Eigen::Vector3d point(int segment, double t) const;  ///< t in [0, 1].

  /// S |Q' x Q''| / |Q'|^3 with S = sgn(N . Q''), +1 where N . Q'' is 0; in 1 / length. 0 where Q'
  /// vanishes.
  double curvature(int segment, double t, const Eigen::Vector3d& normal) const;

 private:
  Eigen::Vector3d tangent(int k) const;

  Eigen::Matrix3Xd points_;
};

}  // namespace morphgrid
