#pragma once
#include <string>
#include <vector>

#include "print/tier_solid.h"

namespace morphgrid {

/// Binary STL: single precision.
std::string stlOf(const SolidMesh& solid);

/// A 3MF package as the core specification has it: one object, a mesh, and one build item a tier,
/// named "tier 1" and so on, side by side along x. Single precision. Throws std::runtime_error when
/// lib3mf cannot write it.
std::string threeMfOf(const std::vector<SolidMesh>& tiers);

}  // namespace morphgrid
