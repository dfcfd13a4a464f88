#include "benchmark/fidelity_run.h"

#include "app/design_scene.h"
#include "core/error.h"
#include "core/rigid_alignment.h"

namespace morphgrid {
namespace {

// Percent of the target's diagonal.
constexpr double kGoalRms = 0.1;
constexpr double kGoalMax = 0.4;

}  // namespace

FidelityRun runForFidelity(Scene scene, const std::filesystem::path& folder,
                           const DeviceOptions& device) {
  scene.pictures.enabled = false;
  const SceneDesign designed = designScene(scene);
  FidelityRun run{.record = runScene(scene, {folder, device, true, {}, {}}),
                  .maxShrinkage = scene.design.maxShrinkage,
                  .targets = designed.targets.value(),
                  .middle = {},
                  .view = designed.view()};
  if (run.record.deviceFailure) {
    throw DeviceError(*run.record.deviceFailure);
  }
  const Eigen::Matrix3Xd middle = middleLayer(run.record.grid.shape, run.record.full->positions);
  run.middle = alignRigidly(middle, run.targets) * middle;
  return run;
}

bool meetsGoal(const FidelityRun& run) {
  const auto& inverse = run.record.inverse;
  const bool reached = !inverse || !inverse->fromFlat || inverse->fromFlat->sameEquilibrium;
  const TargetDistance& distance = run.record.distance.value();
  const ShrinkFigures& shrink = run.record.shrink.value();
  return reached && distance.rmsPercent <= kGoalRms && distance.maxPercent <= kGoalMax &&
         shrink.strutsOverLimit == 0 && shrink.strutsGrowing == 0;
}

}  // namespace morphgrid
