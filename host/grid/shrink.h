#pragma once
#include "grid/strut_grid.h"

namespace morphgrid {

/// What share of its printed length each strut has to lose: 1 - L / printed, the printed length
/// being that of grid.positions, where the stage starts. Below 0 where it would have to grow.
StrutValues computeShrinks(const StrutGrid& grid);

}  // namespace morphgrid
