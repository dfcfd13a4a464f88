#pragma once
#include "grid/strut_grid.h"

namespace morphgrid {

/// Rest lengths on the way from the struts' initial lengths, at grid.positions (share 0), to the
/// designed ones, grid.rest (share 1).
StrutValues loadedRest(const StrutGrid& grid, double share);

}  // namespace morphgrid
