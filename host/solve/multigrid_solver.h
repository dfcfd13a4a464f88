#pragma once
#include <memory>

#include "solve/device_grid.h"
#include "solve/equilibrium.h"

namespace morphgrid {

/// L-BFGS on the device whose initial inverse Hessian is a V-cycle of multigrid on the Gauss-Newton
/// Hessian, by nested iteration: problems of fewer nodes are solved first and start the finer ones.
/// deviceGrid holds the solution afterwards. Iterations are V-cycles, those of coarser grids
/// counted by their share of the vertices. Throws DeviceError when the device fails.
Equilibrium solveMultigrid(const Device& device, const StrutGrid& grid, DeviceGrid& deviceGrid,
                           const SolveOptions& options);

}  // namespace morphgrid
