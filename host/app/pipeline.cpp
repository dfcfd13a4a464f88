#include "app/pipeline.h"

#include <fmt/format.h>

#include <chrono>
#include <fstream>
#include <future>

#include "app/activity_line.h"
#include "app/device_capacity.h"
#include "app/draw_run.h"
#include "app/list_levers.h"
#include "app/restored_run.h"
#include "app/simulate_scene.h"
#include "core/atomic_file.h"
#include "core/create_folder.h"
#include "core/interrupt.h"
#include "core/on_interrupt.h"
#include "export/gltf.h"
#include "export/surface_files.h"
#include "export/vtu.h"
#include "grid/move_joints.h"
#include "report/inverse_plot.h"
#include "report/report_csv.h"
#include "report/report_json.h"

namespace morphgrid {
namespace {

constexpr double kFarOff = 1;  // % of the diagonal: then what would help is looked for.
// Of the surface files: cells per grid cell, along u and v, up to so many triangles. The surface is
// smooth between vertices, which only a coarse grid shows.
constexpr int kFinestRefinement = 4;
constexpr int kMostRefinedFaces = 1000000;

// After Ctrl-C; report and state are written by then, and small files take no time.
constexpr double kSecondsForResults = 1;
constexpr double kLeastSecondsForResults = 0.1;
constexpr const char* kReportFile = "report.json";
constexpr const char* kFilesBesideReport[] = {
    "convergence.csv", "optimise.csv", "optimise.svg", kStateFile,     "surface.obj",
    "surface.ply",     "warped.vtu",   "warped.glb",   "sampling.png", "initial.png",
    "in_plane.png",    "stacked.png",  "shrink.png",   "warped.png",   "surface.png",
    "distance.png",    "target.png",   "printed.vtu"};

constexpr const char* kWritingWhatThereIs =
    "interrupted: writing what there is (report and state, then other files while the first second "
    "lasts); Ctrl-C again drops it";
constexpr const char* kOnlyReportIsWritten =
    "interrupted: report and state are written, of the other files not all; `morphgrid figures` "
    "and "
    "the output folder draw where the run stood";

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

void requireWritableFolder(const std::filesystem::path& folder) {
  createFolder(folder, "--out " + folder.string());
  const PendingFile probe(folder / kReportFile);
  if (!std::ofstream(probe.path())) {
    throw InputError(
        fmt::format("--out {}: no file can be written there: is it read-only?", folder.string()));
  }
}

/// Files of a run before this one, which are not of the report that is about to be there. What is
/// no file stays.
void removeFilesOfBefore(const std::filesystem::path& folder) {
  for (const char* name : kFilesBesideReport) {
    const PendingFile stale(folder / name);  // Removes what killed runs left of it.
    std::error_code ignored;                 // Writing the file anew tells.
    const auto status = std::filesystem::symlink_status(folder / name, ignored);
    if (std::filesystem::is_regular_file(status) || std::filesystem::is_symlink(status)) {
      std::filesystem::remove(folder / name, ignored);
    }
  }
}

void writeReport(const Scene& scene, const SceneDesign& designed, const Simulation& simulation,
                 OutputFiles& files) {
  const RunRecord& record = simulation.record;
  const auto writeText = [&](const char* name, const std::string& text) {
    files.write(name, [&](const auto& path) { writeFileAtomically(path, text); });
  };
  removeFilesOfBefore(files.folder());
  writeText(kReportFile, toJson(record));
  writeText("convergence.csv", toConvergenceCsv(record));
  if (record.inverse) {
    writeText("optimise.csv", toInverseCsv(*record.inverse));
    writeText("optimise.svg", toInversePlot(*record.inverse, scene.design.maxShrinkage));
  }
  if (scene.files.state) {
    files.write(kStateFile,
                [&](const auto& path) { writeState(path, stateOf(scene, designed, simulation)); });
  }
}

/// What the report and the state hold, for people and other programs.
void writeResults(const Scene& scene, const SceneDesign& designed, Simulation& simulation,
                  RunContext& context, OutputFiles& files, bool quiet) {
  const OnInterrupt endingNow(InterruptAct::end, kOnlyReportIsWritten);
  const bool isInterrupted = scene.solve.stopRequested();
  if (isInterrupted) {
    endIn(std::max(kSecondsForResults - secondsSinceInterrupt(), kLeastSecondsForResults));
  }
  simulation.stage.onDevice.reset();  // Its memory is for files now.
  exportFiles(simulation, designed.targets, scene.files, files);
  if (!isInterrupted) {
    const ActivityLine drawing("drawing pictures", quiet);
    const Target* target = designed.target.get();
    drawRun(scene, designed, target ? target->meshSampling() : nullptr, simulation, context);
  } else if (scene.pictures.enabled) {
    simulation.record.notices.emplace_back(kOnlyReportIsWritten);
  }
  endIn(0);
}

int faceCount(const GridShape& shape, int refinement) {
  return 2 * refinement * refinement * shape.layerCellCount();
}

int surfaceRefinement(const GridShape& shape) {
  int refinement = kFinestRefinement;
  while (refinement > 1 && faceCount(shape, refinement) > kMostRefinedFaces) --refinement;
  return refinement;
}

/// Whether OBJ is asked for, but the surface has too many faces for it.
bool isTooLargeForObj(const GridShape& shape, const FileChoices& choices) {
  return choices.obj && faceCount(shape, surfaceRefinement(shape)) > choices.mostObjFaces;
}

void noteFilesLeftOut(const GridShape& shape, const FileChoices& choices, RunRecord& record) {
  if (isTooLargeForObj(shape, choices)) {
    record.notices.push_back(
        fmt::format("surface.obj is left out: {} triangles are more than output.most_obj_faces = "
                    "{}; surface.ply holds them",
                    faceCount(shape, surfaceRefinement(shape)), choices.mostObjFaces));
  }
}

/// Beside the solves, which often wait for the device, the hierarchy over the target's triangles.
std::future<void> prepareClosestPoints(const SceneDesign& designed) {
  return std::async(std::launch::async, [target = designed.target] {
    if (target) target->closestPoints();
  });
}

std::vector<std::string> leversOf(const Scene& scene, const SceneDesign& designed,
                                  const RunRecord& record, bool quiet) {
  const bool isFarOff = record.distance && record.distance->rmsPercent > kFarOff;
  try {
    if (isFarOff && !scene.solve.stopRequested()) {
      const ActivityLine looking("looking for what would help", quiet);
      return listLevers(scene, designed);
    }
  } catch (const Cancelled&) {  // The result is there all the same.
  }
  return {};
}

}  // namespace

void exportFiles(const Simulation& result, const std::optional<Eigen::Matrix3Xd>& targets,
                 const FileChoices& choices, OutputFiles& files) {
  const Stage& stage = result.stage;
  const GridShape& shape = stage.grid.shape;
  const Eigen::Matrix3Xd positions = result.targetFromGrid * stage.equilibrium.positions;
  const JointRotations rotations = moveJoints(result.targetFromGrid, stage.equilibrium.rotations);
  const SurfaceMesh surface =
      tessellate(shape, middleLayer(shape, positions), surfaceRefinement(shape));
  const auto writeIf = [&](bool isChosen, const char* name, const auto& write) {
    if (isChosen) files.write(name, write);
  };
  writeIf(choices.obj && !isTooLargeForObj(shape, choices), "surface.obj",
          [&](const auto& path) { exportObj(path, surface); });
  writeIf(choices.ply, "surface.ply", [&](const auto& path) { exportPly(path, surface); });
  writeIf(choices.vtu, "warped.vtu",
          [&](const auto& path) { exportVtu(path, stage.grid, positions, rotations); });
  writeIf(choices.vtu, "printed.vtu",
          [&](const auto& path) { exportPrintedVtu(path, stage.grid, positions, targets); });
  writeIf(choices.gltf, "warped.glb",
          [&](const auto& path) { exportGltf(path, stage.grid, positions, surface, rotations); });
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
  const OnInterrupt ending(InterruptAct::end, "interrupted before anything was solved");
  const std::shared_ptr<Device> device = deviceFor(scene, options.device, options.quiet);
  const SceneDesign designed = [&] {
    const ActivityLine designing("measuring and designing", options.quiet);
    return designScene(scene, roomOn(device, scene));
  }();
  const std::future<void> closestPoints = prepareClosestPoints(designed);
  CheckpointKeeper keeper = checkpointKeeper(scene, designed, options);
  OutputFiles files(options.outputFolder, options.quiet);
  const PictureOptions picture{.width = scene.pictures.width, .height = scene.pictures.height};
  RunContext context = createRunContext(
      scene, designed, device, picture, [&](const std::string& name, const Panel& panel) {
        files.writeMeanwhile(name + ".png", [panel, picture](const auto& path) {
          writePicture(path, panel, picture);
        });
      });
  context.begun = start;
  if (scene.solve.stopRequested()) {
    throw Cancelled();
  }
  requireWritableFolder(files.folder());
  Simulation simulation;
  RunRecord& record = simulation.record;
  {
    const OnInterrupt saving(InterruptAct::stop, kWritingWhatThereIs);
    simulation = simulateScene(scene, designed, context, keeper, options.quiet);
    record.deviceFailure = context.failure;
    const std::vector<std::string> levers = leversOf(scene, designed, record, options.quiet);
    record.notices.insert(record.notices.end(), levers.begin(), levers.end());
    noteFilesLeftOut(simulation.stage.grid.shape, scene.files, record);
    record.secondsTotal =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    writeReport(scene, designed, simulation, files);
  }
  writeResults(scene, designed, simulation, context, files, options.quiet);
  context.requireSilence();
  if (context.failure) record.deviceFailure = context.failure;
  files.finish();
  record.isInterrupted = scene.solve.stopRequested();
  record.lostFiles = files.lost();
  return std::move(record);
}

}  // namespace morphgrid
