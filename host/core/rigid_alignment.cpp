#include "core/rigid_alignment.h"

namespace morphgrid {

Eigen::Isometry3d alignRigidly(const Eigen::Matrix3Xd& from, const Eigen::Matrix3Xd& to) {
  Eigen::Isometry3d toFromFrom;
  toFromFrom.matrix() = Eigen::umeyama(from, to, false);
  return toFromFrom;
}

}  // namespace morphgrid
