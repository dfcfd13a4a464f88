#pragma once
#include "solve/device_grid.h"
#include "solve/smallest_eigenvalue.h"
#include "solve/v_cycle.h"

namespace morphgrid {

/// One V-cycle of multigrid on the Gauss-Newton Hessian at the device grid's positions, in single
/// precision. Keeps references. Throws DeviceError when the device's limits are exceeded.
Preconditioner vCyclePreconditioner(const Device& device, const DeviceGrid& grid);

/// Preconditions with an existing cycle at its present linearisation: correction is about H^-1
/// rightSide.
Preconditioner vCyclePreconditioner(const Device& device, const VertexVector& rightSide,
                                    const VertexVector& correction, const VCycle& cycle);

/// The constant matrix of projective dynamics, factorised. For devices' absence and small grids:
/// bending is much softer than it says.
Preconditioner constantMatrixPreconditioner(const StrutGrid& grid);

}  // namespace morphgrid
