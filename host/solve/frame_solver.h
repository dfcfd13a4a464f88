#pragma once
#include "grid/strut_grid.h"
#include "solve/equilibrium.h"

namespace morphgrid {

/// The equilibrium of a grid of welded bars on the CPU, in double precision: Newton's method on a
/// sparse Cholesky factorisation, the oracle for the device's methods. Steps are bounded, by 2
/// spacings and 0.5 rad. Where the Hessian is indefinite, each bar's positive part takes its place;
/// where that crawls, near a saddle, the least shift that makes it definite; a saddle is left along
/// a motion of negative curvature. Starts at the grid's positions with joints as printed, or at the
/// checkpoint. Throws InputError when the grid is not valid or has no bars.
Equilibrium solveFrame(const StrutGrid& grid, const SolveOptions& options);

}  // namespace morphgrid
