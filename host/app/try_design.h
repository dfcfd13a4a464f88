#pragma once
#include "app/scene.h"
#include "propose/scene_proposal.h"

namespace morphgrid {

/// Designs as a run does it; what does not work out is the trial's failure.
DesignTrial tryDesign(const MeshRequest& surface, const std::shared_ptr<const Target>& target,
                      const DesignRequest& design, const MaterialRequest& material);

}  // namespace morphgrid
