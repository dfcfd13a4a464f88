#pragma once
#include <functional>

#include "surface/mesh_ray_caster.h"

namespace morphgrid {

/// What rays would hit on the surface x(y, z), no mesh between.
RayHits hitsOn(const std::function<double(double, double)>& x, const SamplingBox& box, int countU,
               int countV);

}  // namespace morphgrid
