#pragma once
#include "propose/scene_proposal.h"

namespace morphgrid {

/// Who is told what is being done, and may end it.
struct ProposalWatch {
  Cancellation cancellation;
  std::function<void(const std::string& what)> onProgress;  ///< May be empty.
};

/// Looks at a mesh from several sides and tries designs in the boxes that are seen there, first the
/// box with the most surface, then gentler ones, other nets and other sides, until one can be
/// printed. Throws InputError when the mesh cannot be read, or with what was tried when no design
/// was possible at all; Cancelled where that is requested.
SceneProposal proposeScene(const ProposalRequest& request, const TryDesign& tryDesign,
                           const ProposalWatch& watch = {});

}  // namespace morphgrid
