#pragma once
#include "grid/strut_grid.h"

namespace morphgrid {

/// The square of the length, in spacings, below which a line of columns of this grid shears rather
/// than bends: 12 times its stiffness to bending over that to shear, the mean of all lines. A part
/// of a line of length d shears by share s^2 / (d^2 + s^2) when its ends are turned against its
/// chord.
double computeShearSquared(const StrutGrid& grid);

}  // namespace morphgrid
