#pragma once
#include "app/scene.h"
#include "app/stages.h"
#include "print/print_record.h"

namespace morphgrid {

/// How a grid morphs whose lateral struts come out as they are laid, not as they were designed:
/// from the design's equilibrium, and by a slow morph from flat. targets: 3 x layerVertexCount, or
/// nothing where only the design's own end is there to compare with; rest: as laid. Nothing when
/// the user has asked to stop. Throws DeviceError when the device fails.
std::optional<LaidShape> simulateLaid(const Scene& scene,
                                      const std::optional<Eigen::Matrix3Xd>& targets,
                                      const Stage& designed, const StrutValues& rest,
                                      const Device& device);

}  // namespace morphgrid
