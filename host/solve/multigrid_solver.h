#pragma once
#include <memory>

#include "solve/device_grid.h"
#include "solve/equilibrium.h"

namespace morphgrid {

/// L-BFGS on the device whose initial inverse Hessian is a V-cycle of multigrid on the Gauss-Newton
/// Hessian, by nested iteration: problems of fewer nodes are solved first and start the finer ones.
/// deviceGrid holds the solution afterwards. Iterations are V-cycles, those of coarser grids
/// counted by their share of the vertices. Throws DeviceError when the device fails, InputError
/// when the checkpoint to resume from is of another grid.
Equilibrium solveMultigrid(const Device& device, const StrutGrid& grid, DeviceGrid& deviceGrid,
                           const SolveOptions& options);

/// What a checkpoint of such a solve says about the positions of `grid`, 3 x vertexCount: those of
/// a coarser grid are prolonged. Throws InputError when it is of another grid.
Eigen::Matrix3Xd finestPositions(const StrutGrid& grid, const SolveCheckpoint& checkpoint);

}  // namespace morphgrid
