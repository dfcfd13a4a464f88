#pragma once
#include <Eigen/Core>

namespace morphgrid {

/// A Catmull-Rom spline through points: Hermite segments with central tangents
/// (rho_{k+1} - rho_{k-1}) / 2, of second order one-sided at the ends, each as a cubic Bezier
/// curve.
class CatmullRomSpline {
 public:
  /// points 3 x n, n >= 2.
  explicit CatmullRomSpline(Eigen::Matrix3Xd points);

  int segmentCount() const { return static_cast<int>(points_.cols()) - 1; }

  /// The four control points of a segment, 3 x 4.
  Eigen::Matrix<double, 3, 4> bezierSegment(int segment) const;

  Eigen::Vector3d point(int segment, double t) const;  ///< t in [0, 1].

  /// S |Q' x Q''| / |Q'|^3 with S = sgn(N . Q''), in 1 / length; 0 where Q' vanishes.
  double curvature(int segment, double t, const Eigen::Vector3d& normal) const;

 private:
  Eigen::Vector3d tangent(int k) const;

  Eigen::Matrix3Xd points_;
};

}  // namespace morphgrid
