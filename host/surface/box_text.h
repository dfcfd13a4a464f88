#pragma once
#include <string>

#include "surface/mesh_ray_caster.h"

namespace morphgrid {

/// The box in as few decimals as its size needs.
SamplingBox roundedBox(const SamplingBox& box);

/// The box as a scene holds it, four lines to paste: `u_start = -1` and so on. What is written is
/// roundedBox().
std::string boxAsToml(const SamplingBox& box);

}  // namespace morphgrid
