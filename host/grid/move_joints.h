#pragma once
#include <Eigen/Geometry>

#include "grid/joint_rotations.h"

namespace morphgrid {

/// How the joints have turned once the whole frame has been moved.
inline JointRotations moveJoints(const Eigen::Isometry3d& motion, JointRotations rotations) {
  const Eigen::Quaterniond turn(motion.linear());
  for (Eigen::Index n = 0; n < rotations.cols(); ++n) {
    rotations.col(n) = (turn * Eigen::Quaterniond(rotations.col(n))).coeffs();
  }
  return rotations;
}

}  // namespace morphgrid
