#include "app/pipeline.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <memory>

#include "app/design_scene.h"
#include "app/pictures.h"
#include "app/progress_line.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "core/interrupt.h"
#include "core/rigid_alignment.h"
#include "export/gltf.h"
#include "export/surface_files.h"
#include "export/vtu.h"
#include "report/report_files.h"
#include "solve/jacobi_solver.h"
#include "solve/multigrid_solver.h"
#include "solve/preconditioners.h"
#include "solve/reference_solver.h"

namespace morphgrid {
namespace {

constexpr int kSurfaceRefinement = 4;  // Cells per grid cell, along u and v, of the surface files.

/// The device and the pictures of a run; a run on the CPU without pictures needs neither.
struct Stagehands {
  std::unique_ptr<Device> device;
  std::unique_ptr<Pictures> pictures;
};

/// A grid on its way to equilibrium, with its copy on the device.
struct Stage {
  StrutGrid grid;
  std::unique_ptr<DeviceGrid> onDevice;
  Equilibrium equilibrium;
};

std::filesystem::path createFolder(const std::filesystem::path& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) {
    throw InputError(
        fmt::format("--out {}: the folder cannot be made: {}", folder.string(), error.message()));
  }
  return folder;
}

Stage prepare(StrutGrid grid, const Stagehands& hands) {
  Stage stage{std::move(grid), nullptr, {}};
  if (hands.device) {
    stage.onDevice = std::make_unique<DeviceGrid>(*hands.device, stage.grid);
  }
  return stage;
}

void solve(Stage& stage, const char* name, const Scene& scene, const RunOptions& options,
           const Stagehands& hands) {
  ProgressLine progress(name, scene.solve.tolerance);
  SolveOptions solveOptions = scene.solve;
  if (!options.quiet) {
    solveOptions.onProgress = [&](const ConvergenceSample& sample) { progress.update(sample); };
  }
  if (scene.method == Method::multigrid) {
    stage.equilibrium = solveMultigrid(*hands.device, stage.grid, *stage.onDevice, solveOptions);
  } else if (scene.method == Method::jacobi) {
    JacobiSolver solver(*hands.device, stage.grid, *stage.onDevice);
    stage.equilibrium = solver.solve(solveOptions);
  } else {
    stage.equilibrium = solveReference(stage.grid, solveOptions);
    if (stage.onDevice) {
      stage.onDevice->uploadPositions(stage.equilibrium.positions);
    }
  }
}

/// On request: is the equilibrium a minimum?
void judge(Stage& stage, Motions motions, const Scene& scene, const Stagehands& hands) {
  if (!scene.smallestEigenvalue || interruptRequested()) {
    return;
  }
  const Preconditioner preconditioner = scene.method == Method::reference
                                            ? constantMatrixPreconditioner(stage.grid)
                                            : vCyclePreconditioner(*hands.device, *stage.onDevice);
  stage.equilibrium.smallestEigenvalue = computeSmallestEigenvalue(
      stage.grid, stage.equilibrium.positions, preconditioner, {.motions = motions});
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

/// One layer of square cells morphs in its plane to what is printed.
Stage runInPlane(const Scene& scene, const RunOptions& options, const GridDesign& design,
                 const Stagehands& hands) {
  Stage stage = prepare(inPlaneGrid(design, scene.weights, scene.scaling), hands);
  if (hands.pictures) {
    hands.pictures->drawFlat("initial", "initial: one layer of square cells", *stage.onDevice,
                             stage.grid.positions);
  }
  solve(stage, "in plane", scene, options, hands);
  judge(stage, Motions::inPlane, scene, hands);
  if (hands.pictures) {
    hands.pictures->drawFlat("in_plane", "in plane: as printed", *stage.onDevice,
                             stage.equilibrium.positions);
  }
  return stage;
}

/// The printed layer, stacked, morphs in space.
Stage runFull(const Scene& scene, const RunOptions& options, const GridDesign& design,
              const Eigen::Matrix3Xd& printedLayer, const Stagehands& hands) {
  Stage stage = prepare(stackedGrid(design, scene.weights, scene.scaling, printedLayer), hands);
  if (hands.pictures) {
    hands.pictures->drawFlat("stacked", "stacked: all layers, before the morph", *stage.onDevice,
                             stage.grid.positions);
  }
  solve(stage, "full", scene, options, hands);
  judge(stage, Motions::inSpace, scene, hands);
  return stage;
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

RunRecord runScene(const Scene& scene, const RunOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  const SceneDesign designed = designScene(scene);
  const std::filesystem::path folder = createFolder(options.outputFolder);
  RunRecord record = recordOf(scene, designed);

  const Stagehands hands = summonStagehands(scene, options, folder);
  if (hands.pictures && designed.sampling) {
    hands.pictures->drawSampling(scene.mesh->mesh, designed.sampling->hits);
  }
  record.device =
      scene.method == Method::reference ? "CPU, double precision" : hands.device->name();

  Stage stage = runInPlane(scene, options, designed.design, hands);
  record.inPlane = stage.equilibrium;
  noteSaddle(record, "in-plane", *record.inPlane);
  if (designed.design.layers > 1) {
    stage = runFull(scene, options, designed.design, record.inPlane->positions, hands);
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
  if (hands.pictures) {
    hands.pictures->drawResult(*stage.onDevice, positions, targetFromGrid, designed.targets);
    if (record.full) {
      hands.pictures->drawShrink(stage.grid, scene.design.maxShrinkage);
    }
  }
  exportFiles(stage, targetFromGrid, scene.files, folder);
  if (hands.device) {
    requireSilence(*hands.device);
  }
  record.secondsTotal =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  writeFileAtomically(folder / "convergence.csv", toConvergenceCsv(record));
  writeFileAtomically(folder / "report.json", toJson(record));
  return record;
}

}  // namespace morphgrid
