#pragma once
#include <Eigen/Geometry>

namespace morphgrid {

/// The rotation and translation that bring `from` closest to `to`, least squares over matching
/// columns. Both 3 x n with n >= 1.
Eigen::Isometry3d alignRigidly(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to);

}  // namespace morphgrid
