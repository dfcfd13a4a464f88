#pragma once
#include "app/scene.h"
#include "app/stages.h"
#include "print/print_plan.h"
#include "print/print_tolerance.h"

namespace morphgrid {

/// How far prints come out from the targets, 3 x layerVertexCount, or where there are none from
/// where the design ends, when shrinks are off: all by the share that is asked for, then random
/// ones, and what matters most. Each is solved from the equilibrium of what is laid. Deterministic
/// for a seed. Throws Cancelled when the user has asked to stop, DeviceError when the device fails.
PrintTolerance assessTolerance(const Scene& scene, const std::optional<Eigen::Matrix3Xd>& targets,
                               const Stage& designed, const PrintPlan& plan,
                               const ToleranceRequest& request, bool quiet, const Device& device);

}  // namespace morphgrid
