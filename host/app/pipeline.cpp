#include "app/pipeline.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <memory>

#include "app/design_scene.h"
#include "app/solve_room.h"
#include "app/stages.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "core/rigid_alignment.h"
#include "export/gltf.h"
#include "export/surface_files.h"
#include "export/vtu.h"
#include "report/report_files.h"

namespace morphgrid {
namespace {

constexpr int kSurfaceRefinement = 4;  // Cells per grid cell, along u and v, of the surface files.

void createFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw InputError(
        fmt::format("--out {}: the folder cannot be made: {}", folder.string(), error.message()));
  }
}

void noteSaddle(RunRecord& record, const char* stage, const Equilibrium& equilibrium) {
  if (verdictOf(equilibrium) == Verdict::saddle) {
    record.notices.push_back(
        fmt::format("the {} stage ended at a saddle, not at a minimum: there is a motion along "
                    "which the energy "
                    "falls; try another solver.method, grid.layer_spacing or grid.nodes_long",
                    stage));
  }
}

void noteOtherWay(RunRecord& record) {
  const auto& inverse = record.inverse;
  if (inverse && inverse->fromFlat && !inverse->fromFlat->sameEquilibrium) {
    record.notices.push_back(fmt::format(
        "the optimised grid has more than one equilibrium: from flat it morphs into another, "
        "{:.3g} "
        "% (RMS) from the target; help it by hand, or try another grid.layer_spacing or "
        "design.optimise",
        inverse->fromFlat->rmsPercent));
  }
}

ClosestPointQuery closestPointsOfTarget(const Scene& scene) {
  return scene.mesh ? ClosestPointQuery(scene.mesh->mesh.vertices, scene.mesh->mesh.triangles)
                    : closestPointsOf(*scene.surface);
}

/// Brings the result to where the target lies; without a target, to where it was printed.
Eigen::Isometry3d alignResult(const Stage& stage, const std::optional<Eigen::Matrix3Xd>& targets) {
  const Eigen::Matrix3Xd& positions = stage.equilibrium.positions;
  return targets ? alignRigidly(middleLayer(stage.grid.shape, positions), *targets)
                 : alignRigidly(positions, stage.grid.positions);
}

void exportFiles(const Stage& stage, const Eigen::Isometry3d& targetFromGrid,
                 const FileChoices& choices, const std::filesystem::path& folder) {
  const GridShape& shape = stage.grid.shape;
  const Eigen::Matrix3Xd positions = targetFromGrid * stage.equilibrium.positions;
  const SurfaceMesh surface = tessellate(shape.verticesU, shape.verticesV,
                                         middleLayer(shape, positions), kSurfaceRefinement);
  if (choices.gltf) {
    exportGltf(folder / "warped.glb", stage.grid, positions, surface);
  }
  if (choices.vtu) {
    exportVtu(folder / "warped.vtu", stage.grid, positions);
  }
  if (choices.ply) {
    exportPly(folder / "surface.ply", surface);
  }
  if (choices.obj) {
    exportObj(folder / "surface.obj", surface);
  }
}

void requireSilence(const Device& device) {
  if (!device.validationMessages().empty()) {
    throw DeviceError(fmt::format("the validation layers complain:\n{}",
                                  fmt::join(device.validationMessages(), "\n")));
  }
}

Stagehands summonStagehands(const Scene& scene, const RunOptions& options,
                            const std::filesystem::path& folder) {
  Stagehands hands;
  if (scene.method != Method::reference || scene.pictures.enabled) {
    hands.device = std::make_unique<Device>(options.device);
  }
  if (scene.pictures.enabled) {
    hands.pictures = std::make_unique<Pictures>(*hands.device, scene.pictures, folder,
                                                scene.mesh ? kMeshView : kPatchView);
  }
  return hands;
}

/// Throws InputError before anything is solved: nobody wants to learn it after hours.
CheckpointKeeper checkpointKeeper(const Scene& scene, const GridDesign& design,
                                  const RunOptions& options) {
  const auto settings = checkpointSettings(scene, design);
  CheckpointKeeper keeper(options.checkpoint, settings);
  if (!options.checkpoint.file.empty()) {
    requireWritableCheckpoint(options.checkpoint.file);
  }
  if (!options.resumeFrom.empty()) {
    Checkpoint checkpoint = readCheckpoint(options.resumeFrom);
    requireSameSettings(options.resumeFrom, checkpoint, settings);
    keeper.resume(std::move(checkpoint));
  }
  return keeper;
}

void requireRoom(const Scene& scene, const GridShape& shape, const Stagehands& hands) {
  if (hands.device) {
    if (const auto reason = whyTooLarge(shape, scene.method, roomOn(*hands.device))) {
      throw InputError(fmt::format("{}: {}", scene.file.string(), *reason));
    }
  }
}

/// What of the design and of its result cannot be printed, or cannot be.
void examine(const Stage& stage, const Scene& scene, RunRecord& record) {
  const auto tell = [&](const std::vector<std::string>& advice) {
    record.notices.insert(record.notices.end(), advice.begin(), advice.end());
  };
  if (record.full) {
    record.shrink = computeShrink(stage.grid, scene.design.maxShrinkage);
    tell(adviseOn(*record.shrink, scene.design.maxShrinkage));
  }
  record.feasibility = examineFeasibility(stage.grid.shape, stage.equilibrium.positions,
                                          scene.design.strutThickness);
  tell(adviseOn(*record.feasibility));
}

}  // namespace

RunRecord checkScene(const Scene& scene) { return recordOf(scene, designScene(scene)); }

void noteMissingRoom(const Scene& scene, RunRecord& record) {
  try {
    const auto reason = whyTooLarge(record.grid.shape, scene.method, roomOn(Device()));
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
  CheckpointKeeper keeper = checkpointKeeper(scene, designed.design, options);
  RunRecord record = recordOf(scene, designed);

  const std::filesystem::path& folder = options.outputFolder;
  Stagehands hands = summonStagehands(scene, options, folder);
  requireRoom(scene, record.grid.shape, hands);
  createFolder(folder);
  if (designed.sampling) {
    hands.draw([&](Pictures& pictures) {
      pictures.drawSampling(scene.mesh->mesh, designed.sampling->hits);
    });
  }
  record.device =
      scene.method == Method::reference ? "CPU, double precision" : hands.device->name();

  Stages stages(scene, hands, keeper, options.quiet);
  Stage stage = stages.runInPlane(designed.design);
  record.inPlane = stage.equilibrium;
  noteSaddle(record, "in-plane", *record.inPlane);
  if (designed.design.layers > 1) {
    stage = stages.runFull(designed.design, record.inPlane->positions);
    record.printScale = stage.printScale;
    if (designed.targets) {
      record.inverse = stages.improve(stage, *designed.targets);
      noteOtherWay(record);
    }
    record.full = stage.equilibrium;
    noteSaddle(record, "full", *record.full);
  }

  const Eigen::Matrix3Xd& positions = stage.equilibrium.positions;
  record.errors = computeStrutErrors(designed.design, stage.grid, positions);
  examine(stage, scene, record);
  if (designed.targets) {
    record.distance = computeTargetDistance(middleLayer(stage.grid.shape, positions),
                                            *designed.targets, closestPointsOfTarget(scene));
  }
  const Eigen::Isometry3d targetFromGrid = alignResult(stage, designed.targets);
  hands.draw([&](Pictures& pictures) {
    pictures.drawResult(*stage.onDevice, positions, targetFromGrid, designed.targets);
    if (record.full) {
      pictures.drawShrink(stage.grid, scene.design.maxShrinkage);
    }
  });
  exportFiles(stage, targetFromGrid, scene.files, folder);
  if (hands.device && !hands.failure) {
    requireSilence(*hands.device);
  }
  record.deviceFailure = hands.failure;
  record.secondsTotal =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  writeFileAtomically(folder / "convergence.csv", toConvergenceCsv(record));
  if (record.inverse) {
    writeFileAtomically(folder / "optimise.csv", toInverseCsv(*record.inverse));
  }
  writeFileAtomically(folder / "report.json", toJson(record));
  return record;
}

}  // namespace morphgrid
