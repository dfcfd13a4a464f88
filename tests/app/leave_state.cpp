#include "tests/app/leave_state.h"

#include "app/restored_run.h"

namespace morphgrid {

std::filesystem::path leaveState(const std::filesystem::path& file,
                                 const std::vector<std::string>& overrides,
                                 std::shared_ptr<Device> device) {
  const Scene scene = loadScene(file, overrides);
  const SceneDesign designed = designScene(scene);
  RunContext context;
  context.device = std::move(device);
  CheckpointKeeper keeper({}, {});
  const Simulation simulation = simulateScene(scene, designed, context, keeper, true);
  const std::filesystem::path folder = file.parent_path() / "out";
  std::filesystem::create_directories(folder);
  writeState(folder / kStateFile, stateOf(scene, designed, simulation));
  return folder / kStateFile;
}

}  // namespace morphgrid
