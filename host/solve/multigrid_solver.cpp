#include "solve/multigrid_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "energy/strut_energy.h"
#include "solve/checkpoint_pace.h"
#include "solve/imperfection.h"
#include "solve/nested_grids.h"
#include "solve/preconditioned_descent.h"

namespace morphgrid {
namespace {

using Clock = std::chrono::steady_clock;

// A coarser grid is solved to this share of its energy: more would not spare the finer one a cycle.
constexpr double kCoarseTolerance = 1e-4;
// The energy's predicted decrease varies from step to step; so many small ones count as the end.
constexpr int kQuietSteps = 3;
// The host's residual, in double precision, decides in the end: it must not be just above.
constexpr double kResidualMargin = 0.98;
// For the time left: what grids not yet begun will take.
constexpr double kExpectedCycles = 20;
// Energy, in stiffness x spacing^2 a vertex, that positions cannot tell from none.
constexpr double kNoEnergy = 1e-13;

/// The last steps on one grid: whether the energy has come to rest, and when it will.
class EnergyFall {
 public:
  /// noEnergy: as good as zero, where a share of the energy means nothing.
  EnergyFall(double tolerance, double noEnergy) : tolerance_(tolerance), noEnergy_(noEnergy) {}

  void add(const PreconditionedDescent& descent) {
    const double share =
        descent.energy() > noEnergy_ ? descent.predictedDecrease() / descent.energy() : 0;
    quietSteps_ = share < tolerance_ ? quietSteps_ + 1 : 0;
    shares_.push_back(share);
  }

  int quietSteps() const { return quietSteps_; }

  /// Steps to the tolerance, judged by the last half of them.
  double stepsLeft() const {
    const std::size_t span = shares_.size() / 2;
    if (span < 2 || tolerance_ <= 0) {
      return kExpectedCycles;
    }
    const double now = shares_.back();
    const double fall = std::log(shares_[shares_.size() - 1 - span] / now);
    return fall > 0 ? std::max(0.0, std::log(now / tolerance_)) * double(span) / fall
                    : kExpectedCycles;
  }

 private:
  double tolerance_;
  double noEnergy_;
  int quietSteps_ = 0;
  std::vector<double> shares_;
};

/// What has happened since solveMultigrid() began. Work is counted in cycles on the finest grid.
class Progress {
 public:
  Progress(const SolveOptions& options, const std::vector<NestedGrid>& grids)
      : options_(options), grids_(grids), pace_(options) {
    if (const auto& from = options.resumeFrom) {
      phase_ = from->phase;
      cycles_ = from->iterations;
      start_ -=
          std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(from->seconds));
      history_ = from->history;
    }
    for (std::size_t n = phase_; n < grids.size(); ++n) {
      cyclesToCome_ += kExpectedCycles * share(grids[n].grid);
    }
  }

  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  double cycles() const { return cycles_; }
  std::vector<ConvergenceSample>& history() { return history_; }

  void beginGrid(std::size_t n) {
    const StrutGrid& grid = grids_[n].grid;
    phase_ = n;
    share_ = share(grid);
    energyScale_ = grid.spacing * grid.spacing;
    const double stiffness = 2 * StrutEnergy(grid).constraintWeights().mean();
    const double count = grid.shape.vertexCount();
    residualScale_ = 1 / (stiffness * std::sqrt(count));
    noEnergy_ = kNoEnergy * stiffness * count;
    cyclesToCome_ -= kExpectedCycles * share_;
  }

  /// A coarser grid, or none: the grid itself.
  void tellGrid(std::shared_ptr<const DeviceGrid> grid) const {
    if (options_.onGrid) {
      options_.onGrid(std::move(grid));
    }
  }

  double noEnergy() const { return noEnergy_; }
  double residualOf(const PreconditionedDescent& descent) const {
    return descent.gradientNorm() * residualScale_;
  }

  /// After a step on the grid begun last. Tells the world.
  void add(const PreconditionedDescent& descent, const EnergyFall& fall) {
    cycles_ += share_;
    const double residual = residualOf(descent);
    if (!std::isfinite(descent.energy()) || !std::isfinite(residual)) {
      throw DeviceError(
          fmt::format("the solve left the range of numbers at cycle {:.0f}", cycles_));
    }
    const double cyclesLeft = cyclesToCome_ + fall.stepsLeft() * share_;
    history_.push_back({static_cast<long>(std::ceil(cycles_)), descent.energy() * energyScale_,
                        residual, seconds(), share_, seconds() / cycles_ * cyclesLeft});
    if (options_.onProgress) {
      options_.onProgress(history_.back());
    }
    const int phase = static_cast<int>(phase_);
    pace_.offer(phase, reasonToStop().has_value(), [&] {
      return SolveCheckpoint{phase, descent.positions(), cycles_, seconds(), history_};
    });
  }

  std::optional<StopReason> reasonToStop() const {
    if (options_.stopRequested()) {
      return StopReason::interrupted;
    }
    if (cycles_ >= static_cast<double>(options_.iterationLimit)) {
      return StopReason::iterationLimit;
    }
    return std::nullopt;
  }

 private:
  double share(const StrutGrid& grid) const {
    return double(grid.shape.vertexCount()) / grids_.back().grid.shape.vertexCount();
  }

  const SolveOptions& options_;
  const std::vector<NestedGrid>& grids_;
  CheckpointPace pace_;
  Clock::time_point start_ = Clock::now();
  std::size_t phase_ = 0;  ///< The grid begun last.
  double share_ = 1;
  double energyScale_ = 1;
  double residualScale_ = 1;  ///< From a gradient's norm, see StrutEnergy::residual().
  double noEnergy_ = 0;       ///< As PreconditionedDescent::energy().
  double cycles_ = 0;
  double cyclesToCome_ = 0;  ///< On grids not yet begun, about.
  std::vector<ConvergenceSample> history_;
};

Precision precisionOf(const Device& device) {
  return device.hasFloat64() ? Precision::precise : Precision::single;
}

/// Positions of a coarser grid's equilibrium, about.
Eigen::Matrix3Xd solveCoarse(const Device& device, const StrutGrid& grid, Progress& progress) {
  const auto deviceGrid = std::make_shared<DeviceGrid>(device, grid);
  PreconditionedDescent descent(device, *deviceGrid, precisionOf(device));
  progress.tellGrid(deviceGrid);
  EnergyFall fall(kCoarseTolerance, progress.noEnergy());
  while (!progress.reasonToStop() && fall.quietSteps() == 0 && descent.iterate()) {
    fall.add(descent);
    progress.add(descent, fall);
  }
  return descent.positions();
}

/// Where the finest grid starts: the nested ones are solved, those that the checkpoint leaves.
Eigen::Matrix3Xd solveNested(const Device& device, const std::vector<NestedGrid>& grids,
                             const std::optional<SolveCheckpoint>& from, Progress& progress) {
  std::size_t n = from ? from->phase : 0;
  Eigen::Matrix3Xd positions =
      from ? from->positions : withImperfection(grids.front().grid, grids.front().grid.positions);
  for (; n + 1 < grids.size(); ++n) {
    if (!progress.reasonToStop()) {
      StrutGrid coarse = grids[n].grid;
      coarse.positions = std::move(positions);
      progress.beginGrid(n);
      positions = solveCoarse(device, coarse, progress);
    }
    positions = withImperfection(grids[n + 1].grid, prolong(grids[n], positions, grids[n + 1]));
  }
  return positions;
}

/// Runs until there is a reason to stop.
StopReason descend(PreconditionedDescent& descent, const SolveOptions& options,
                   Progress& progress) {
  EnergyFall fall(options.energyTolerance, progress.noEnergy());
  for (;;) {
    // Of long, soft grids a small residual says little: the energy must have come to rest too.
    const bool isQuiet = fall.quietSteps() > 0 || options.energyTolerance == 0;
    if (isQuiet && progress.residualOf(descent) <= kResidualMargin * options.tolerance) {
      return StopReason::residual;
    }
    if (fall.quietSteps() >= kQuietSteps) {
      return StopReason::energy;
    }
    if (const auto reason = progress.reasonToStop()) {
      return *reason;
    }
    if (!descent.iterate()) {
      return StopReason::stagnated;
    }
    fall.add(descent);
    progress.add(descent, fall);
  }
}

StopReason solveFinest(const Device& device, DeviceGrid& deviceGrid, const SolveOptions& options,
                       Progress& progress, std::size_t phase) {
  // Setting up the finest grid takes a while: not for somebody who has asked to stop.
  if (const auto reason = progress.reasonToStop()) {
    return *reason;
  }
  PreconditionedDescent descent(device, deviceGrid, precisionOf(device));
  progress.beginGrid(phase);
  progress.tellGrid(nullptr);
  const StopReason reason = descend(descent, options, progress);
  descent.finish();
  return reason;
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

}  // namespace

Eigen::Matrix3Xd finestPositions(const StrutGrid& grid, const SolveCheckpoint& checkpoint) {
  const std::vector<NestedGrid> grids = nestGridsFor(grid, checkpoint);
  Eigen::Matrix3Xd positions = checkpoint.positions;
  for (std::size_t n = checkpoint.phase; n + 1 < grids.size(); ++n) {
    positions = prolong(grids[n], positions, grids[n + 1]);
  }
  return positions;
}

Equilibrium solveMultigrid(const Device& device, const StrutGrid& grid, DeviceGrid& deviceGrid,
                           const SolveOptions& options) {
  const std::vector<NestedGrid> grids = options.startsNear ? std::vector<NestedGrid>{{grid, 1}}
                                                           : nestGridsFor(grid, options.resumeFrom);
  Progress progress(options, grids);
  if (!options.startsNear) {
    deviceGrid.uploadPositions(solveNested(device, grids, options.resumeFrom, progress));
  }
  Equilibrium result;
  result.reason = solveFinest(device, deviceGrid, options, progress, grids.size() - 1);

  result.positions = deviceGrid.downloadPositions();
  const StrutEnergy energy(grid);
  const StrutEnergy::Value value = energy.evaluate(result.positions);
  result.energy = value.energy;
  result.residual = energy.residual(value.gradient);
  // The device may see a slightly other residual than the host in double: the host decides.
  if (result.residual <= options.tolerance) {
    result.reason = StopReason::residual;
  } else if (result.reason == StopReason::residual) {
    result.reason = StopReason::stagnated;
  }
  result.converged = result.reason == StopReason::residual || result.reason == StopReason::energy;
  result.iterations = static_cast<long>(std::ceil(progress.cycles()));
  result.seconds = progress.seconds();
  result.history = std::move(progress.history());
  result.history.push_back({result.iterations, result.energy, result.residual, result.seconds});
  return result;
}

}  // namespace morphgrid
