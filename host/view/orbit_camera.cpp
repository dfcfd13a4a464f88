#include "view/orbit_camera.h"

#include <algorithm>
#include <numbers>

namespace morphgrid {
namespace {

constexpr double kNearest = 1e-3;  // Distances, in sizes of the scene.
constexpr double kFarthest = 1e2;
constexpr double kDeepest = 1e4;  // Far plane over near plane: more would cost depth's precision.
constexpr double kRoom = 0.55;    // About a box's middle, in its diagonals: struts have a width.

Eigen::Matrix3Xd cornersOf(const Eigen::AlignedBox3d& box) {
  Eigen::Matrix3Xd corners(3, 8);
  for (int n = 0; n < 8; ++n) {
    corners.col(n) = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(n));
  }
  return corners;
}

}  // namespace

void OrbitCamera::frame(const Eigen::AlignedBox3d& box, const View& view, double aspect) {
  take(frameAll(cornersOf(box), view.direction, view.up, aspect), box);
}

void OrbitCamera::frameAgain(const Eigen::AlignedBox3d& box, double aspect) {
  frame(box, {-rotation_.row(2).transpose(), rotation_.row(1).transpose()}, aspect);
}

void OrbitCamera::take(const Camera& camera, const Eigen::AlignedBox3d& box) {
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 3; ++column) {
      rotation_(row, column) = camera.viewFromWorld[column][row];
    }
  }
  const glm::dvec3 at = camera.eye();
  const Eigen::Vector3d eye(at.x, at.y, at.z);
  const Eigen::Vector3d backwards = rotation_.row(2);
  distance_ = (eye - box.center()).dot(backwards);
  pivot_ = eye - distance_ * backwards;
  size_ = box.diagonal().norm() > 0 ? box.diagonal().norm() : 1;
}

void OrbitCamera::turn(double right, double down) {
  const Eigen::Vector3d backwards = rotation_.row(2);
  const double elevation = std::asin(std::clamp(backwards.dot(axis_), -1.0, 1.0));
  const double quarter = std::numbers::pi / 2;
  const double pitch = std::clamp(elevation + down, -quarter, quarter) - elevation;
  const Eigen::Vector3d sideways = rotation_.row(0);
  rotation_ = rotation_ * Eigen::AngleAxisd(pitch, sideways) * Eigen::AngleAxisd(right, axis_);
  // Rounding adds up over many turns.
  rotation_ = Eigen::Quaterniond(rotation_).normalized().toRotationMatrix();
}

void OrbitCamera::pan(double right, double up, double aspect) {
  const double height = 2 * distance_ * viewSlope(aspect);
  pivot_ -= height * (right * rotation_.row(0) + up * rotation_.row(1)).transpose();
}

void OrbitCamera::zoom(double factor) {
  distance_ = std::clamp(distance_ * factor, kNearest * size_, kFarthest * size_);
}

Camera OrbitCamera::camera(const Eigen::AlignedBox3d& box, double aspect) const {
  const Eigen::Vector3d backwards = rotation_.row(2);
  const Eigen::Vector3d eye = pivot_ + distance_ * backwards;
  const double middle = (eye - box.center()).dot(backwards);
  const double reach = kRoom * std::max(box.diagonal().norm(), kNearest * size_);
  const double farPlane = std::max(middle + reach, kNearest * size_);
  const double nearPlane = std::max(middle - reach, farPlane / kDeepest);
  return cameraAt(eye, rotation_, aspect, nearPlane, farPlane);
}

}  // namespace morphgrid
