#pragma once
#include <functional>

#include "surface/point_lattice.h"

namespace morphgrid {

/// Points at even parameters of [0, 1]^2.
PointLattice latticeOn(const std::function<Eigen::Vector3d(double, double)>& point, int countU,
                       int countV);

}  // namespace morphgrid
