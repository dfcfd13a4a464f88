#pragma once
#include "benchmark/fidelity_run.h"
#include "render/image.h"

namespace morphgrid {

/// The target, the paper's design and ours side by side, seen by one camera, in one scale of
/// colours for the distance.
Image drawFidelity(const Device& device, const FidelityTrio& trio);

}  // namespace morphgrid
