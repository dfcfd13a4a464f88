#pragma once
#include <functional>

#include "surface/mesh_ray_caster.h"

namespace morphgrid {

/// Rays of which each hits at x(u, v), or misses where that is NaN.
RayHits sampleHits(const SamplingBox& box, int countU, int countV,
                   const std::function<double(double, double)>& x);

/// Makes rays [firstU, lastU] x [firstV, lastV] miss.
void punchHole(RayHits& hits, int firstU, int lastU, int firstV, int lastV);

/// How many rays miss.
long countMisses(const RayHits& hits);

}  // namespace morphgrid
