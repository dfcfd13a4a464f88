#pragma once
#include "grid/strut_grid.h"
#include "solve/equilibrium.h"

namespace morphgrid {

/// CPU, double precision: L-BFGS whose initial inverse Hessian is the prefactorised constant matrix
/// of projective dynamics (Cholesky). The oracle and the speed peer of the device's methods. Throws
/// InputError when the grid is not valid.
Equilibrium solveReference(const StrutGrid& grid, const SolveOptions& options);

}  // namespace morphgrid
