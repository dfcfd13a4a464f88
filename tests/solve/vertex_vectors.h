#pragma once
#include <Eigen/Core>
#include <vector>

#include "shared/solver_types.h"

namespace morphgrid {

/// x, y, z of one vertex after the other, as the device keeps them, and back.
std::vector<vec4> packVector(const Eigen::VectorXd& values);
Eigen::VectorXd unpackVector(const std::vector<vec4>& packed);

}  // namespace morphgrid
