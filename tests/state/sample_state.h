#pragma once
#include "state/run_state.h"

namespace morphgrid {

/// A state of 3 layers of 3 x 2 nodes with all that a state may hold, but of no real run.
RunState sampleState();

/// The same grid before inverse design changed it, of bend angles: without target or mesh.
RunState plainState();

/// One layer, which ends after the stage in the plane.
RunState flatState();

}  // namespace morphgrid
