#pragma once
#include "app/simulate_scene.h"
#include "state/run_state.h"

namespace morphgrid {

/// What a run leaves for commands that go on from it.
RunState stateOf(const Scene& scene, const SceneDesign& designed, const Simulation& simulation);

/// A finished run, as its state has kept it.
struct RestoredRun {
  Scene scene;
  std::filesystem::path sceneFile;  ///< Where the scene came from.
  SceneDesign designed;
  Simulation simulation;  ///< Nothing is on the device.
  StrutGrid inPlane;      ///< The grid of the stage in the plane.
  std::optional<MeshSampling> sampling;
};

/// overrides: of keys that do not change what was run, see loadScene(). Throws InputError when the
/// state or what its scene names cannot be read.
RestoredRun restoreRun(const std::filesystem::path& state,
                       const std::vector<std::string>& overrides = {});

}  // namespace morphgrid
