#include "app/pipeline.h"

#include <fmt/format.h>

#include <chrono>

#include "app/device_capacity.h"
#include "app/list_levers.h"
#include "app/restored_run.h"
#include "app/simulate_scene.h"
#include "core/atomic_file.h"
#include "core/create_folder.h"
#include "export/gltf.h"
#include "export/surface_files.h"
#include "export/vtu.h"
#include "grid/move_joints.h"
#include "report/inverse_plot.h"
#include "report/report_csv.h"
#include "report/report_json.h"

namespace morphgrid {
namespace {

constexpr double kFarOff = 1;          // % of the diagonal: then what would help is looked for.
constexpr int kSurfaceRefinement = 4;  // Cells per grid cell, along u and v, of the surface files.

void writePicture(const std::filesystem::path& path, const Panel& panel, PictureOptions options) {
  options.caption = panel.caption;
  options.legend = panel.legend;
  options.scaleBar = panel.scaleBar;
  writePng(path, composePicture(panel.scene, options));
}

/// Throws InputError before anything is solved: nobody wants to learn it after hours.
CheckpointKeeper checkpointKeeper(const Scene& scene, const SceneDesign& designed,
                                  const RunOptions& options) {
  const ProblemIdentity problem = identifyProblem(scene, designed);
  CheckpointKeeper keeper(options.checkpoint, problem);
  if (!options.checkpoint.file.empty()) {
    requireWritableCheckpoint(options.checkpoint.file);
  }
  if (!options.resumeFrom.empty()) {
    Checkpoint checkpoint = readCheckpoint(options.resumeFrom);
    requireSameProblem(options.resumeFrom, checkpoint, problem);
    keeper.resume(std::move(checkpoint));
  }
  return keeper;
}

}  // namespace

void exportFiles(const Simulation& result, const std::optional<Eigen::Matrix3Xd>& targets,
                 const FileChoices& choices, const std::filesystem::path& folder) {
  const Stage& stage = result.stage;
  const GridShape& shape = stage.grid.shape;
  const Eigen::Matrix3Xd positions = result.targetFromGrid * stage.equilibrium.positions;
  const JointRotations rotations = moveJoints(result.targetFromGrid, stage.equilibrium.rotations);
  const SurfaceMesh surface = tessellate(shape, middleLayer(shape, positions), kSurfaceRefinement);
  if (choices.gltf) {
    exportGltf(folder / "warped.glb", stage.grid, positions, surface, rotations);
  }
  if (choices.vtu) {
    exportVtu(folder / "warped.vtu", stage.grid, positions, rotations);
    exportPrintedVtu(folder / "printed.vtu", stage.grid, positions, targets);
  }
  if (choices.ply) {
    exportPly(folder / "surface.ply", surface);
  }
  if (choices.obj) {
    exportObj(folder / "surface.obj", surface);
  }
}

RunRecord checkScene(const Scene& scene) { return recordOf(scene, designScene(scene)); }

void noteInsufficientDevice(const Scene& scene, RunRecord& record) {
  try {
    const auto reason = explainOverflow(record.grid.shape, workloadOf(scene), capacityOf(Device()));
    if (reason) {
      record.notices.push_back(*reason);
    }
  } catch (const DeviceError&) {
    // Checking a scene needs no device; a run will say what is wrong with it.
  }
}

RunRecord runScene(const Scene& scene, const RunOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const SceneDesign designed = designScene(scene);
  CheckpointKeeper keeper = checkpointKeeper(scene, designed, options);
  const std::filesystem::path& folder = options.outputFolder;
  const PictureOptions picture{.width = scene.pictures.width, .height = scene.pictures.height};
  RunContext context = createRunContext(scene, designed, options.device, picture,
                                        [&](const std::string& name, const Panel& panel) {
                                          writePicture(folder / (name + ".png"), panel, picture);
                                        });
  if (scene.solve.stopRequested()) {
    throw Cancelled();
  }
  createFolder(folder, "--out " + folder.string());
  Simulation simulation = simulateScene(scene, designed, context, keeper, options.quiet);
  context.requireSilence();
  RunRecord& record = simulation.record;
  record.deviceFailure = context.failure;
  if (record.distance && record.distance->rmsPercent > kFarOff && !scene.solve.stopRequested()) {
    const std::vector<std::string> levers = listLevers(scene, designed);
    record.notices.insert(record.notices.end(), levers.begin(), levers.end());
  }
  record.secondsTotal =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  writeFileAtomically(folder / "convergence.csv", toConvergenceCsv(record));
  if (record.inverse) {
    writeFileAtomically(folder / "optimise.csv", toInverseCsv(*record.inverse));
    writeFileAtomically(folder / "optimise.svg",
                        toInversePlot(*record.inverse, scene.design.maxShrinkage));
  }
  writeFileAtomically(folder / "report.json", toJson(record));
  if (scene.files.state) {
    writeState(folder / kStateFile, stateOf(scene, designed, simulation));
  }
  // Last: the files of a large grid may exceed what their formats or the disk hold.
  exportFiles(simulation, designed.targets, scene.files, folder);
  return std::move(record);
}

}  // namespace morphgrid
