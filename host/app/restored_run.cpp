#include "app/restored_run.h"

namespace morphgrid {
namespace {

SceneDesign designOf(RunState& state) {
  SceneDesign designed;
  designed.design = std::move(state.design);
  designed.measurement = state.record.measurement;
  designed.net = state.record.net;
  designed.targets = std::move(state.targets);
  designed.angleErrors = std::move(state.angleErrors);
  designed.mesh = state.record.mesh;
  designed.notices = textsOf(state.record.notices);
  if (state.sampling) {
    designed.ownView = kMeshView;
  }
  return designed;
}

/// As the run had it, whatever has become of its printer and material files.
MaterialRequest materialAsRun(const Scene& scene, const RunRecord& record) {
  MaterialRequest material = scene.material;
  if (record.bars) {
    material.barWidth = record.bars->width;
    material.barHeight = record.bars->height;
    material.postWidth = record.bars->post;
    material.jointRadius = record.bars->joint;
  }
  return material;
}

Stage lastStage(RunState& state) {
  return {
      .grid = std::move(state.grid),
      .onDevice = nullptr,
      .solver = nullptr,
      .equilibrium = state.equilibrium(),
      .printScale = state.record.printScale,
      .mmPerUnit = state.record.print ? std::optional(state.record.print->scale) : std::nullopt};
}

}  // namespace

RunState stateOf(const Scene& scene, const SceneDesign& designed, const Simulation& simulation) {
  RunState state{.program = "morphgrid " MORPHGRID_VERSION,
                 .scene = scene.text,
                 .sceneFile = std::filesystem::absolute(scene.file),
                 .design = designed.design,
                 .targets = designed.targets,
                 .sampling = {},
                 .grid = simulation.stage.grid,
                 .targetFromGrid = simulation.targetFromGrid,
                 .record = simulation.record};
  state.angleErrors = designed.angleErrors;
  if (const auto* sampling = designed.target ? designed.target->meshSampling() : nullptr) {
    state.sampling = *sampling;
  }
  return state;
}

RestoredRun restoreRun(const std::filesystem::path& file,
                       const std::vector<std::string>& overrides) {
  RunState state = readState(file);
  RestoredRun run{.scene = loadSceneText(state.scene, file, state.record.scene, overrides),
                  .sceneFile = state.sceneFile,
                  .designed = designOf(state),
                  .simulation = {},
                  .inPlane = {},
                  .sampling = std::move(state.sampling)};
  const Scene& scene = run.scene;
  const GridDesign& design = run.designed.design;
  state.record.published = scene.published;
  run.inPlane = inPlaneGrid(design, scene.weights, scene.scaling);
  StrutGrid stacked = design.layers == 1
                          ? run.inPlane
                          : stackedGrid(design, scene.weights, scene.scaling,
                                        state.record.printScale * state.record.inPlane->positions);
  if (design.layers > 1) {
    applyMaterial(stacked, materialAsRun(scene, state.record));
  }
  Stage stage = lastStage(state);
  stage.shrinkBounds = shrinkBoundsOf(scene, stage.mmPerUnit);
  stage.grid.bars = stacked.bars;
  stage.grid.printedCorners = stacked.printedCorners;
  Equilibrium& last = stage.equilibrium;
  if (last.rotations.cols() == 0) {
    last.rotations = turnWithBars(stage.grid, last.positions);
  }
  run.simulation = {std::move(state.record), std::move(stage), state.targetFromGrid};
  return run;
}

}  // namespace morphgrid
