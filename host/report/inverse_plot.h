#pragma once
#include <string>

#include "inverse/inverse_design.h"

namespace morphgrid {

/// optimise.svg: distance to the target and largest shrink over the steps of inverse design.
/// maxShrinkage: share of its printed length that a strut can lose.
std::string toInversePlot(const InverseDesign& inverse, double maxShrinkage);

}  // namespace morphgrid
