#include "solve/multigrid_solver.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"
#include "energy/grid_energy.h"
#include "solve/adjoint_solver.h"
#include "solve/imperfection.h"
#include "solve/preconditioners.h"
#include "solve/solve_progress.h"

namespace morphgrid {
namespace {

// A coarser grid is solved to this share of its energy: more would not spare the finer one a cycle.
constexpr double kCoarseTolerance = 1e-4;
// The host's residual, in double precision, decides in the end: it must not be just above.
constexpr double kResidualMargin = 0.98;

Precision precisionOf(const Device& device) {
  return device.hasFloat64() ? Precision::precise : Precision::single;
}

/// Runs until there is a reason to stop.
StopReason descend(PreconditionedDescent& descent, const SolveOptions& options,
                   SolveProgress& progress) {
  EnergyFall fall(options.energyTolerance, progress.noEnergy());
  for (;;) {
    // For long, soft grids a small residual says little: the energy must have come to rest too.
    const bool isQuiet = fall.isQuiet(1) || options.energyTolerance == 0;
    if (isQuiet && progress.residualOf(descent) <= kResidualMargin * options.tolerance) {
      return StopReason::residual;
    }
    if (fall.isQuiet(options.quietSteps)) {
      return StopReason::energy;
    }
    if (const auto reason = progress.reasonToStop()) {
      return *reason;
    }
    const bool falls = descent.iterate();
    fall.add(descent);
    if (!falls) {
      return fall.quietSteps() > 0 ? StopReason::energy : StopReason::stagnated;
    }
    progress.add(descent, fall);
  }
}

std::vector<NestedGrid> nestGridsFor(const StrutGrid& grid,
                                     const std::optional<SolveCheckpoint>& checkpoint) {
  std::vector<NestedGrid> grids = nestGrids(grid);
  if (checkpoint) {
    const auto phase = static_cast<std::size_t>(checkpoint->phase);
    const auto count = checkpoint->positions.cols();
    if (phase >= grids.size() || count != grids[phase].grid.shape.vertexCount()) {
      throw InputError(fmt::format(
          "the checkpoint's {} positions of nested grid {} are not of this grid", count, phase));
    }
  }
  return grids;
}

std::vector<int> vertexCountsOf(const std::vector<NestedGrid>& grids) {
  std::vector<int> counts;
  for (const NestedGrid& nested : grids) {
    counts.push_back(nested.grid.shape.vertexCount());
  }
  return counts;
}

}  // namespace

MultigridSolver::MultigridSolver(const Device& device, StrutGrid grid,
                                 std::shared_ptr<DeviceGrid> deviceGrid)
    : device_(device),
      grid_(std::move(grid)),
      energy_(std::make_unique<GridEnergy>(grid_)),
      deviceGrid_(std::move(deviceGrid)) {}

MultigridSolver::MultigridSolver(const Device& device, const StrutGrid& grid)
    : MultigridSolver(device, grid, std::make_shared<DeviceGrid>(device, grid)) {}

MultigridSolver::~MultigridSolver() = default;

void MultigridSolver::setRest(const StrutValues& rest) {
  deviceGrid_->uploadRest(rest);
  grid_.rest = rest;
}

void MultigridSolver::setGrid(StrutGrid grid) {
  const bool wasUniform = deviceGrid_->uniformStiffness().has_value();
  const bool wasLoaded = deviceGrid_->isLoaded();
  const std::vector<int> wereFree = deviceGrid_->freeMotions();
  const int mostVertices = deviceGrid_->mostVertices();
  deviceGrid_->assign(grid);
  grid_ = std::move(grid);
  energy_ = std::make_unique<GridEnergy>(grid_);
  if (deviceGrid_->uniformStiffness().has_value() != wasUniform ||
      deviceGrid_->isLoaded() != wasLoaded || deviceGrid_->freeMotions() != wereFree ||
      deviceGrid_->mostVertices() != mostVertices) {
    adjoint_.reset();  // Kernels and smoothers are made for them.
    descent_.reset();
  } else if (descent_) {
    descent_->forgetHessian();
  }
}

void MultigridSolver::moveTo(const Eigen::Matrix3Xd& positions) {
  moveTo(positions, turnWithBars(grid_, positions));
}

void MultigridSolver::moveTo(const Eigen::Matrix3Xd& positions, const JointRotations& rotations) {
  deviceGrid_->uploadPositions(positions, rotations);
}

PreconditionedDescent& MultigridSolver::descent() {
  if (!descent_) {
    descent_ = std::make_unique<PreconditionedDescent>(device_, *deviceGrid_, precisionOf(device_));
  }
  return *descent_;
}

Eigen::Matrix3Xd MultigridSolver::solveCoarse(const StrutGrid& grid,
                                              SolveProgress& progress) const {
  const auto deviceGrid = std::make_shared<DeviceGrid>(device_, grid);
  deviceGrid->uploadPositions(grid.positions, turnWithBars(grid, grid.positions));
  PreconditionedDescent descent(device_, *deviceGrid, precisionOf(device_));
  progress.tellGrid(deviceGrid);
  EnergyFall fall(kCoarseTolerance, progress.noEnergy());
  while (!progress.reasonToStop() && fall.quietSteps() == 0 && descent.iterate()) {
    fall.add(descent);
    progress.add(descent, fall);
  }
  return descent.positions();
}

Eigen::Matrix3Xd MultigridSolver::solveNested(const std::vector<NestedGrid>& grids,
                                              const std::optional<SolveCheckpoint>& from,
                                              SolveProgress& progress) const {
  std::size_t n = from ? static_cast<std::size_t>(from->phase) : 0;
  Eigen::Matrix3Xd positions =
      from ? from->positions : withImperfection(grids.front().grid, grids.front().grid.positions);
  for (; n + 1 < grids.size(); ++n) {
    if (!progress.reasonToStop()) {
      StrutGrid coarse = grids[n].grid;
      coarse.positions = std::move(positions);
      progress.beginGrid(n, coarse.spacing, GridEnergy(coarse).meanStiffness());
      positions = solveCoarse(coarse, progress);
    }
    positions = prolong(grids[n], positions, grids[n + 1]);
    if (!progress.reasonToStop()) {
      positions = withImperfection(grids[n + 1].grid, std::move(positions));
    }
  }
  return positions;
}

StopReason MultigridSolver::solveFinest(std::size_t phase, const SolveOptions& options,
                                        SolveProgress& progress) {
  // Setting up the finest grid takes a while: not for somebody who has asked to stop.
  if (const auto reason = progress.reasonToStop()) {
    return *reason;
  }
  PreconditionedDescent& finest = descent();
  finest.begin(options.startsNear);
  progress.beginGrid(phase, grid_.spacing, energy_->meanStiffness());
  progress.tellGrid(nullptr);
  const StopReason reason = descend(finest, options, progress);
  finest.finish();
  return reason;
}

Equilibrium MultigridSolver::leave(const ConvergenceSample& last) const {
  Equilibrium result;
  result.positions = deviceGrid_->downloadPositions();
  result.rotations = deviceGrid_->downloadRotations(deviceGrid_->positions());
  result.energy = last.energy;
  result.residual = last.residual;
  result.reason = StopReason::interrupted;
  return result;
}

Equilibrium MultigridSolver::assess(StopReason reason, const SolveOptions& options) const {
  Equilibrium result;
  result.positions = deviceGrid_->downloadPositions();
  result.rotations = deviceGrid_->downloadRotations(deviceGrid_->positions());
  const GridEnergy::Value value = energy_->evaluate(result.positions, result.rotations);
  result.energy = value.energy;
  result.residual = value.residual;
  // The device may see a slightly other residual than the host in double: the host decides.
  result.reason = reason;
  if (result.residual <= options.tolerance) {
    result.reason = StopReason::residual;
  } else if (reason == StopReason::residual) {
    // Where energies count, descend() has seen this one at rest.
    result.reason = options.energyTolerance > 0 ? StopReason::energy : StopReason::stagnated;
  }
  result.converged = result.reason == StopReason::residual || result.reason == StopReason::energy;
  return result;
}

Equilibrium MultigridSolver::solve(const SolveOptions& options) {
  std::vector<NestedGrid> nested;
  std::vector<int> vertexCounts{grid_.shape.vertexCount()};
  if (!options.startsNear) {
    nested = nestGridsFor(grid_, options.resumeFrom);
    vertexCounts = vertexCountsOf(nested);
  }
  SolveProgress progress(options, vertexCounts);
  if (!options.startsNear) {
    const auto& from = options.resumeFrom;
    if (from && static_cast<std::size_t>(from->phase) + 1 == nested.size() &&
        from->rotations.cols() == from->positions.cols()) {
      moveTo(from->positions, from->rotations);
    } else {
      moveTo(solveNested(nested, from, progress));
    }
    nested.clear();
  }
  const StopReason reason = solveFinest(vertexCounts.size() - 1, options, progress);
  const auto& history = progress.history();
  const bool isLeft =
      reason == StopReason::interrupted && !history.empty() && history.back().gridShare == 1;
  Equilibrium result = isLeft ? leave(history.back()) : assess(reason, options);
  result.iterations = static_cast<long>(std::ceil(progress.cycles()));
  result.seconds = progress.seconds();
  result.history = std::move(progress.history());
  result.history.push_back({result.iterations, result.energy, result.residual, result.seconds});
  return result;
}

Adjoint MultigridSolver::solveAdjoint(const Eigen::Matrix3Xd& rightSide,
                                      const AdjointOptions& options) {
  if (!adjoint_) {
    adjoint_ = std::make_unique<AdjointSolver>(device_, descent());
  }
  if (!grid_.bars) {
    return adjoint_->solve(rightSide, options);
  }
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, descent().vectorLength());
  forces.leftCols(rightSide.cols()) = rightSide;
  Adjoint adjoint = adjoint_->solve(forces, options);
  adjoint.lambda.rightCols(rightSide.cols()) /= grid_.spacing;
  return adjoint;
}

Preconditioner MultigridSolver::preconditioner() {
  PreconditionedDescent& finest = descent();
  finest.takeHessian();
  return vCyclePreconditioner(device_, finest.rightSide(), finest.correction(), finest.cycle());
}

Equilibrium solveMultigrid(const Device& device, const StrutGrid& grid, DeviceGrid& deviceGrid,
                           const SolveOptions& options) {
  return MultigridSolver(device, grid, {std::shared_ptr<void>(), &deviceGrid}).solve(options);
}

Eigen::Matrix3Xd finestPositions(const StrutGrid& grid, const SolveCheckpoint& checkpoint) {
  const std::vector<NestedGrid> grids = nestGridsFor(grid, checkpoint);
  Eigen::Matrix3Xd positions = checkpoint.positions;
  for (auto n = static_cast<std::size_t>(checkpoint.phase); n + 1 < grids.size(); ++n) {
    positions = prolong(grids[n], positions, grids[n + 1]);
  }
  return positions;
}

}  // namespace morphgrid
