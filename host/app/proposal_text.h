#pragma once
#include <filesystem>
#include <string>

#include "propose/scene_proposal.h"

namespace morphgrid {

/// The scene file of a proposal, with a comment for each choice. meshConfiguration: as the scene
/// names it.
std::string proposalSceneText(const SceneProposal& proposal,
                              const std::filesystem::path& meshConfiguration);

/// The mesh configuration that it names. mesh: as that names it.
std::string proposalMeshText(const SceneProposal& proposal, const std::filesystem::path& mesh);

/// What was decided and what comes next, some lines for a terminal.
std::string proposalSummary(const SceneProposal& proposal);

}  // namespace morphgrid
