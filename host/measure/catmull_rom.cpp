#include "measure/catmull_rom.h"

#include <Eigen/Geometry>
#include <cassert>

namespace morphgrid {

using Eigen::Vector3d;

CatmullRomSpline::CatmullRomSpline(Eigen::Matrix3Xd points) : points_(std::move(points)) {
  assert(points_.cols() >= 2);
}

Vector3d CatmullRomSpline::tangent(int k) const {
  const Eigen::Matrix3Xd& p = points_;
  const auto last = static_cast<int>(p.cols()) - 1;
  if (last == 1) {
    return p.col(1) - p.col(0);
  }
  if (k == 0) {
    return -1.5 * p.col(0) + 2 * p.col(1) - 0.5 * p.col(2);
  }
  if (k == last) {
    return 1.5 * p.col(last) - 2 * p.col(last - 1) + 0.5 * p.col(last - 2);
  }
  return (p.col(k + 1) - p.col(k - 1)) / 2;
}

Eigen::Matrix<double, 3, 4> CatmullRomSpline::bezierSegment(int segment) const {
  assert(segment >= 0 && segment < segmentCount());
  const Vector3d start = points_.col(segment);
  const Vector3d end = points_.col(segment + 1);
  Eigen::Matrix<double, 3, 4> bezier;
  bezier << start, start + tangent(segment) / 3, end - tangent(segment + 1) / 3, end;
  return bezier;
}

Vector3d CatmullRomSpline::point(int segment, double t) const {
  const double s = 1 - t;
  return bezierSegment(segment) *
         Eigen::Vector4d(s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t);
}

double CatmullRomSpline::curvature(int segment, double t, const Vector3d& normal) const {
  const Eigen::Matrix<double, 3, 4> bezier = bezierSegment(segment);
  const Eigen::Matrix3d steps = bezier.rightCols<3>() - bezier.leftCols<3>();
  const double s = 1 - t;
  const Vector3d first = 3 * steps * Vector3d(s * s, 2 * s * t, t * t);
  const Vector3d second =
      6 * (s * (steps.col(1) - steps.col(0)) + t * (steps.col(2) - steps.col(1)));
  const double speed = first.norm();
  if (speed == 0) {
    return 0;
  }
  const double curvature = (first / speed).cross(second).norm() / (speed * speed);
  return normal.dot(second) >= 0 ? curvature : -curvature;
}

}  // namespace morphgrid
