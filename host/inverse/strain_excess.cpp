#include "inverse/strain_excess.h"

#include <cmath>

namespace morphgrid {

StrainExcess computeStrainExcess(const LateralRest& lateral, const Eigen::VectorXd& rest,
                                 const Eigen::Matrix3Xd& positions, double bound, double diagonal) {
  StrainExcess excess;
  const double weight = diagonal * diagonal;
  Eigen::Index n = 0;
  forEachLateralStrut(lateral.shape(), [&](const Strut& strut) {
    const double designed = rest[n++];
    const Eigen::Vector3d arm = positions.col(strut.to) - positions.col(strut.from);
    const double length = arm.norm();
    const double strain = length / designed - 1;
    const double beyond = std::abs(strain) - bound;
    if (beyond <= 0) return;
    if (excess.penalty == 0) {
      excess.byPositions = Eigen::Matrix3Xd::Zero(3, positions.cols());
      excess.byRest = Eigen::VectorXd::Zero(rest.size());
    }
    excess.penalty += weight / 2 * beyond * beyond;
    const double byStrain = weight * std::copysign(beyond, strain);
    const Eigen::Vector3d byArm = byStrain / (designed * length) * arm;
    excess.byPositions.col(strut.to) += byArm;
    excess.byPositions.col(strut.from) -= byArm;
    excess.byRest[n - 1] = -byStrain * length / (designed * designed);
  });
  return excess;
}

}  // namespace morphgrid
