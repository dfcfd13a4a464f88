#include "benchmark/fidelity_run.h"

#include "app/design_scene.h"
#include "core/error.h"
#include "core/rigid_alignment.h"
#include "state/run_state.h"

namespace morphgrid {
namespace {

// Percent of the target's diagonal.
constexpr double kGoalRms = 0.1;
constexpr double kGoalMax = 0.4;

}  // namespace

FidelityRun runForFidelity(Scene scene, const std::filesystem::path& folder,
                           const DeviceOptions& device, const MaterialRequest& bars) {
  scene.pictures.enabled = false;
  scene.files = {.gltf = false, .vtu = false, .ply = false, .obj = false, .state = true};
  const SceneDesign designed = designScene(scene);
  FidelityRun run{.record = runScene(scene, {folder, device, true, {}, {}}),
                  .maxShrinkage = scene.design.maxShrinkage,
                  .frame = {},
                  .targets = designed.targets.value(),
                  .middle = {},
                  .view = designed.view()};
  if (run.record.deviceFailure) {
    throw DeviceError(*run.record.deviceFailure);
  }
  const RunState state = readState(folder / kStateFile);
  run.frame = judgeAsFrame(Device(device), state.grid, run.targets, bars);
  run.middle = alignRigidly(run.frame.middle, run.targets) * run.frame.middle;
  return run;
}

bool meetsGoal(const FidelityRun& run) {
  const ShapePercent& distance = run.frame.asDesigned;
  const ShrinkFigures& shrink = run.record.shrink.value();
  return distance.rms <= kGoalRms && distance.max <= kGoalMax && shrink.strutsOverLimit == 0 &&
         shrink.strutsGrowing == 0;
}

}  // namespace morphgrid
