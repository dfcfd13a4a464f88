#pragma once
#include <Eigen/Geometry>
#include <filesystem>
#include <optional>
#include <string>

#include "design/grid_design.h"
#include "grid/strut_grid.h"
#include "report/run_record.h"
#include "surface/mesh_sampling.h"

namespace morphgrid {

/// What a run leaves for commands that go on from it, without designing and solving again.
struct RunState {
  std::string program;              ///< The program that wrote it, with its version.
  std::string scene;                ///< The whole scene file in one text, which stands alone.
  std::filesystem::path sceneFile;  ///< Where the scene came from.
  GridDesign design;                ///< Without notices: the record has all.
  std::optional<Eigen::Matrix3Xd> targets;  ///< 3 x layerVertexCount: the target's points.
  std::optional<MeshSampling> sampling;     ///< None but for meshes.
  StrutGrid grid;                           ///< The grid of the last stage, as printed.
  Eigen::Isometry3d targetFromGrid;         ///< Brings the result to where the target lies.
  RunRecord record;                         ///< As readReport() gives it, with the stages whole.
  /// layerVertexCount, rad, of conformal sheets: see printedAngleErrors(); else empty.
  Eigen::VectorXd angleErrors{};

  /// Where the last stage came to rest.
  const Equilibrium& equilibrium() const { return record.full ? *record.full : *record.inPlane; }
};

/// The name of the file in a run's folder.
inline constexpr const char* kStateFile = "state.safetensors";

/// Replaces the file as a whole. Throws InputError when the disk refuses.
void writeState(const std::filesystem::path& file, const RunState& state);

/// Throws InputError when the file cannot be read, is no state of a run, damaged or of another
/// version. The grid is sound, as validate() has it; sizes fit together.
RunState readState(const std::filesystem::path& file);

/// The state that a command's argument names, a run's folder or the file itself; nothing when it
/// names something else, say a scene. Throws InputError for a folder without a state.
std::optional<std::filesystem::path> findState(const std::filesystem::path& argument);

}  // namespace morphgrid
