#pragma once
#include "inverse/lateral_rest.h"

namespace morphgrid {

/// How far lateral struts are strained beyond a bound: `diagonal^2 / 2 sum max(0, |l/L - 1| -
/// bound)^2`, so that an excess weighs as much as one vertex that is off by that share of the
/// diagonal. Derivatives are empty where nothing is in excess.
struct StrainExcess {
  double penalty = 0;
  Eigen::Matrix3Xd byPositions;  ///< 3 x vertexCount
  Eigen::VectorXd byRest;        ///< In the order of LateralRest.
};

/// rest: lateral rest lengths; positions: 3 x vertexCount; diagonal: a length, > 0.
StrainExcess computeStrainExcess(const LateralRest& lateral, const Eigen::VectorXd& rest,
                                 const Eigen::Matrix3Xd& positions, double bound, double diagonal);

}  // namespace morphgrid
