#include "app/stages.h"

#include <fmt/format.h>

#include <cmath>

#include "design/joint_loads.h"
#include "energy/grid_energy.h"
#include "inverse/print_scale.h"
#include "solve/frame_solver.h"
#include "solve/jacobi_solver.h"
#include "solve/preconditioners.h"
#include "solve/reference_solver.h"

namespace morphgrid {
namespace {

Equilibrium laidOut(const Sheet& sheet) {
  Equilibrium result;
  result.positions = Eigen::Matrix3Xd::Zero(3, sheet.positions.cols());
  result.positions.topRows<2>() = sheet.positions;
  result.iterations = sheet.iterations;
  result.seconds = sheet.seconds;
  result.converged = true;
  result.reason = StopReason::laidOut;
  return result;
}

constexpr int kStepsThatTellARate = 3;

// What parts of a run take over the full stage, of a large grid: guesses for who waits.
constexpr double kInPlaneOverFull = 0.35;
constexpr double kInverseStepOverFull = 0.5;
constexpr double kResultsOverFull = 0.3;

/// Those of each layer, bottom first, in the order of LateralRest.
Eigen::VectorXd lateralRestOf(const GridShape& shape,
                              const std::vector<LateralField<double>>& layers) {
  Eigen::VectorXd rest(shape.lateralStrutCount());
  Eigen::Index n = 0;
  forEachLateralStrut(shape,
                      [&](const Strut& strut) { rest[n++] = layers[strut.layer].at(strut); });
  return rest;
}

}  // namespace

Stage Stages::prepare(Stage stage) {
  if (context_.device) {
    context_.attempt([&] {
      if (scene_.method == Method::multigrid) {
        stage.solver = context_.solverFor(stage.grid);
        stage.onDevice = stage.solver->onDevice();
      } else {
        stage.onDevice = std::make_shared<DeviceGrid>(*context_.device, stage.grid);
      }
    });
  }
  if (context_.onStage) {
    context_.onStage(stage);
  }
  return stage;
}

std::optional<Equilibrium> Stages::solveByMethod(Stage& stage, const SolveOptions& options) {
  if (scene_.method == Method::reference) {
    return stage.grid.bars ? solveFrame(stage.grid, options) : solveReference(stage.grid, options);
  }
  std::optional<Equilibrium> result;
  context_.attempt([&] {
    result = scene_.method == Method::multigrid
                 ? stage.solver->solve(options)
                 : JacobiSolver(*context_.device, stage.grid, *stage.onDevice).solve(options);
  });
  return result;
}

void Stages::showOnDevice(const Stage& stage) {
  if (stage.onDevice) {
    context_.attempt([&] {
      stage.onDevice->uploadPositions(stage.equilibrium.positions, stage.equilibrium.rotations);
    });
  }
}

/// Of a stage that is not begun any more: solvers of large grids take long to make.
Equilibrium Stages::untouched(const StrutGrid& grid) const {
  Equilibrium result = lastKnown(grid);
  result.reason = StopReason::interrupted;
  return result;
}

/// Where the solve stood when the device failed.
Equilibrium Stages::lastKnown(const StrutGrid& grid) const {
  Equilibrium result;
  result.reason = StopReason::deviceFailure;
  result.positions = grid.positions;
  if (const auto& checkpoint = keeper_.latest()) {
    result.positions = scene_.method == Method::multigrid ? finestPositions(grid, *checkpoint)
                                                          : checkpoint->positions;
    result.iterations = static_cast<long>(std::ceil(checkpoint->iterations));
    result.seconds = checkpoint->seconds;
    result.history = checkpoint->history;
  }
  result.rotations = turnWithBars(grid, result.positions);
  const GridEnergy::Value value = GridEnergy(grid).evaluate(result.positions, result.rotations);
  result.energy = value.energy;
  result.residual = value.residual;
  return result;
}

StageOutlook Stages::outlookOf(const StrutGrid& grid) const {
  const std::chrono::duration<double> before = std::chrono::steady_clock::now() - context_.begun;
  const int steps = scene_.design.compensateRounds + scene_.design.optimiseSteps;
  const double afterFull = kInverseStepOverFull * steps + kResultsOverFull;
  const bool isInPlane = grid.shape.layers == 1 && scene_.design.layers > 1;
  return {before.count(), isInPlane ? (1 + afterFull) / kInPlaneOverFull : afterFull};
}

void Stages::solve(Stage& stage, const char* name, const Eigen::Matrix3Xd& near) {
  ProgressLine progress(name, scene_.solve.tolerance, outlookOf(stage.grid));
  SolveOptions options = scene_.solve;
  if (!quiet_) {
    options.onProgress = [&](const ConvergenceSample& sample) { progress.update(sample); };
  }
  options.onCheckpoint = [&](SolveCheckpoint checkpoint) { keeper_.keep(std::move(checkpoint)); };
  options.resumeFrom = keeper_.latest();
  if (scene_.method == Method::multigrid && stage.onDevice &&
      near.cols() == stage.grid.shape.vertexCount()) {
    context_.attempt([&] { stage.solver->moveTo(near); });
    options.startsNear = true;
  }
  auto result = solveByMethod(stage, options);
  stage.equilibrium = result ? std::move(*result) : lastKnown(stage.grid);
  keeper_.endSolve(stage.equilibrium);
}

/// On request: is the equilibrium a minimum?
void Stages::assessStability(Stage& stage, Motions motions) {
  if (!scene_.smallestEigenvalue || scene_.solve.stopRequested()) {
    return;
  }
  const auto assessBy = [&](const Preconditioner& preconditioner) {
    Equilibrium& equilibrium = stage.equilibrium;
    equilibrium.smallestEigenvalue =
        stage.grid.bars ? computeSmallestEigenvalue(stage.grid, equilibrium.positions,
                                                    equilibrium.rotations, preconditioner)
                        : computeSmallestEigenvalue(stage.grid, equilibrium.positions,
                                                    preconditioner, {.motions = motions});
  };
  if (scene_.method == Method::reference) {
    assessBy(constantMatrixPreconditioner(stage.grid));
  } else {
    context_.attempt([&] {
      assessBy(stage.solver ? stage.solver->preconditioner()
                            : vCyclePreconditioner(*context_.device, *stage.onDevice));
    });
  }
}

std::optional<InverseDesign> Stages::improve(Stage& stage, const SceneDesign& designed) {
  const DesignRequest& request = scene_.design;
  const int stepCount = request.compensateRounds + request.optimiseSteps;
  if ((stepCount == 0 && !request.enforceShrinkage) || scene_.solve.stopRequested() ||
      !stage.solver || context_.failure) {
    return std::nullopt;
  }
  ProgressLine progress("inverse design", scene_.solve.tolerance);
  InverseOptions options{.compensateRounds = request.compensateRounds,
                         .optimiseSteps = request.optimiseSteps,
                         .solve = scene_.solve};
  if (request.enforceShrinkage) {
    options.shrinkBounds = stage.shrinkBounds;
  }
  options.maxStrain = request.maxStrain;
  if (request.layout == Layout::conformal && request.reference == Reference::middle) {
    options.lengthsFor = [&](const Eigen::Matrix3Xd& points) {
      const GridShape layer = stage.grid.shape.layer();
      const Eigen::Matrix3Xd normals =
          carryNormals(layer, *designed.targets, designed.normals, points);
      return lateralRestOf(stage.grid.shape,
                           lengthsOnOffsets(layer, points, normals, designed.stack));
    };
  }
  int done = -1;  // The design itself is no step.
  options.onStep = [&](const InverseStep& step) {
    ++done;
    if (!quiet_) {
      progress.tell(fmt::format("step {} of {}, distance {:.3g} % RMS, {:.3g} % at most", done,
                                stepCount, step.rmsPercent, step.maxPercent),
                    step.seconds,
                    done >= kStepsThatTellARate ? step.seconds / done * (stepCount - done) : -1);
    }
  };
  if (context_.onCheckFromFlat) {
    options.onCheckFromFlat = [&] { context_.onCheckFromFlat(stage.solver->grid()); };
  }
  std::optional<ProgressLine> check;
  options.onFromFlat = [&](int step, int steps, double seconds) {
    if (quiet_) return;
    if (!check) check.emplace("check from flat", scene_.solve.tolerance);
    check->tell(fmt::format("step {} of {}", step, steps), seconds, -1);
  };
  options.onCheckpoint = [&](InverseCheckpoint checkpoint) { keeper_.keep(std::move(checkpoint)); };
  options.resumeFrom = keeper_.inverse();
  keeper_.beginInverseDesign(stage.equilibrium);
  InverseDesigner designer(*stage.solver, *designed.targets, options);
  std::optional<InverseDesign> result;
  context_.attempt([&] { result = designer.run(stage.equilibrium); });
  keeper_.endInverseDesign(!result || scene_.solve.stopRequested());
  if (!result) {
    result = designer.salvage();
  }
  if (result) {
    stage.grid.rest = result->rest;
    stage.equilibrium = result->equilibrium;
    assessDesign(stage);
  }
  return result;
}

/// The check from flat has left the solver elsewhere.
void Stages::assessDesign(Stage& stage) {
  if (!scene_.smallestEigenvalue) {
    return;
  }
  context_.attempt([&] {
    stage.solver->setRest(stage.grid.rest);
    stage.solver->moveTo(stage.equilibrium.positions, stage.equilibrium.rotations);
  });
  assessStability(stage, Motions::inSpace);
}

std::optional<WeightFigures> Stages::assessWeight(const Stage& stage) {
  if (!scene_.material.gravity) {
    return std::nullopt;
  }
  WeightFigures figures{.newtons = weightInNewtons(stage.grid, scene_.material), .sag = {}};
  if (stage.solver && !scene_.solve.stopRequested()) {
    context_.attempt([&] {
      stage.solver->moveTo(stage.equilibrium.positions, stage.equilibrium.rotations);
      const Adjoint answer = stage.solver->solveAdjoint(stage.grid.bars->loads->forces);
      if (answer.converged) {
        const int count = stage.grid.shape.vertexCount();
        figures.sag = answer.lambda.leftCols(count).colwise().norm().maxCoeff();
      }
    });
  }
  return figures;
}

void Stages::reachPrintedLayer(Stage& stage, const Sheet* sheet) {
  if (keeper_.inPlane()) {
    stage.equilibrium = *keeper_.inPlane();
    return;
  }
  if (sheet) {
    stage.equilibrium = laidOut(*sheet);
  } else {
    solve(stage, "in plane", context_.nearInPlane);
  }
  keeper_.beginFullStage(stage.equilibrium);
}

Stage Stages::runInPlane(const GridDesign& design, const Sheet* sheet) {
  Stage stage = prepare({.grid = inPlaneGrid(design, scene_.weights, scene_.scaling),
                         .shrinkBounds = shrinkBoundsOf(scene_, std::nullopt)});
  reachPrintedLayer(stage, sheet);
  showOnDevice(stage);
  if (!sheet) {
    assessStability(stage, Motions::inPlane);
  }
  stage.solver.reset();
  return stage;
}

Stage Stages::runFull(const SceneDesign& designed, const Eigen::Matrix3Xd& printedLayer) {
  const auto mmPerUnitAt = [&](double scale) {
    return designed.mmPerUnit ? designed.mmPerUnit
                              : mmPerUnitOf(scene_, scale * printedLayer.topRows<2>());
  };
  const auto stackedAt = [&](double scale) {
    return stackedGrid(designed.design, scene_.weights, scene_.scaling, scale * printedLayer);
  };
  double printScale = 1;
  if (scene_.design.enforceShrinkage && scene_.design.layout != Layout::conformal) {
    printScale = choosePrintScale(
        stackedAt(1), [&](double scale) { return shrinkBoundsOf(scene_, mmPerUnitAt(scale)); });
  }
  const std::optional<double> mmPerUnit = mmPerUnitAt(printScale);
  StrutGrid grid = stackedAt(printScale);
  applyMaterial(grid, materialOf(scene_, mmPerUnit));
  Stage stage{.grid = std::move(grid),
              .printScale = printScale,
              .mmPerUnit = mmPerUnit,
              .shrinkBounds = shrinkBoundsOf(scene_, mmPerUnit)};
  if (scene_.solve.stopRequested()) {
    stage.equilibrium = untouched(stage.grid);
    return stage;
  }
  stage = prepare(std::move(stage));
  if (keeper_.full()) {
    stage.equilibrium = *keeper_.full();
  } else {
    solve(stage, "full", context_.nearFull);
  }
  showOnDevice(stage);
  assessStability(stage, Motions::inSpace);
  return stage;
}

}  // namespace morphgrid
