#pragma once
#include <filesystem>

#include "propose/scene_proposal.h"

namespace morphgrid {

/// The mesh from all sides, beside the scene and among a run's pictures.
inline constexpr const char* kPreviewFile = "preview.png";

struct ProposedFiles {
  std::filesystem::path scene;  ///< FOLDER/NAME.toml; it names FOLDER/NAME_mesh.toml.
  SceneProposal proposal;
  bool hasScene;                  ///< Whether both could be written.
  std::vector<std::string> lost;  ///< Files that could not be written and why.
};

/// Proposes a scene for a mesh and writes it and its mesh configuration into a folder; empty:
/// out/NAME of the mesh. What was there and differs is kept as NAME_before.toml. Tells on stderr
/// what is being done, unless quiet. Throws as proposeScene(), and InputError when there is no
/// such folder.
ProposedFiles proposeFiles(const ProposalRequest& request, std::filesystem::path folder,
                           bool isQuiet);

/// Prints what was decided, and where it is.
void tellProposal(const ProposedFiles& files);

/// Says which material a proposal is for: what its struts lose. Throws InputError when the file
/// cannot be read.
void setMaterialFile(ProposalRequest& request, const std::filesystem::path& file);

/// A scene for the mesh of a request, written into a folder as above; told, unless quiet. Throws
/// OutputError when it cannot be written.
std::filesystem::path proposedScene(const ProposalRequest& request,
                                    const std::filesystem::path& folder, bool isQuiet);

/// The scene that a command works on: the argument itself, or, where it is a mesh, one that is
/// proposed for it as above. Throws OutputError when that cannot be written.
std::filesystem::path sceneFor(const std::filesystem::path& argument,
                               const std::filesystem::path& folder, bool isQuiet);

}  // namespace morphgrid
