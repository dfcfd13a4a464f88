#pragma once
#include <Eigen/Geometry>

#include "render/camera.h"

namespace morphgrid {

/// A camera that turns about a point, the pivot, on a turntable whose axis points up.
class OrbitCamera {
 public:
  /// axis: unit length.
  explicit OrbitCamera(const Eigen::Vector3d& axis) : axis_(axis) {}

  /// Looks along `direction` at a box, as near as shows all of it. aspect = width / height.
  void frame(const Eigen::AlignedBox3d& box, const View& view, double aspect);
  /// As frame(), from where it looks now.
  void frameAgain(const Eigen::AlignedBox3d& box, double aspect);

  /// Angles in radians: the scene turns to the right, and its top towards the eye; never over.
  void turn(double right, double down);
  /// In heights of the picture: the scene moves so far to the right and up.
  void pan(double right, double up, double aspect);
  /// factor > 0: of the distance; kept where numbers are sound.
  void zoom(double factor);

  /// What it sees of a box: all of it is between its near and its far plane where it is in front.
  Camera camera(const Eigen::AlignedBox3d& box, double aspect) const;

  const Eigen::Vector3d& pivot() const { return pivot_; }
  double distance() const { return distance_; }
  /// Rows: right, up, and towards the eye.
  const Eigen::Matrix3d& rotation() const { return rotation_; }

 private:
  void take(const Camera& camera, const Eigen::AlignedBox3d& box);

  Eigen::Vector3d axis_;
  Eigen::Vector3d pivot_ = Eigen::Vector3d::Zero();
  Eigen::Matrix3d rotation_ = Eigen::Matrix3d::Identity();
  double distance_ = 1;
  double size_ = 1;  ///< Size of the box that was framed last.
};

}  // namespace morphgrid
