#pragma once
#include <functional>

#include "surface/mesh_ray_caster.h"

namespace morphgrid {

/// What a lattice of rays would hit on the surface x(y, z), no mesh between.
PointLattice hitsOn(const std::function<double(double, double)>& x, const SamplingBox& box,
                    int countU, int countV);

}  // namespace morphgrid
