#include "solve/multigrid_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "core/interrupt.h"
#include "solve/energy.h"
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
      : options_(options), finest_(grids.back().grid) {
    for (const NestedGrid& nested : grids) {
      cyclesToCome_ += kExpectedCycles * share(nested.grid);
    }
  }

  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  double cycles() const { return cycles_; }
  std::vector<ConvergenceSample>& history() { return history_; }

  void beginGrid(const StrutGrid& grid) {
    share_ = share(grid);
    energyScale_ = grid.spacing * grid.spacing;
    const double stiffness = 2 * StrutEnergy(grid).constraintWeights().mean();
    const double count = grid.shape.vertexCount();
    residualScale_ = 1 / (stiffness * std::sqrt(count));
    noEnergy_ = kNoEnergy * stiffness * count;
    cyclesToCome_ -= kExpectedCycles * share_;
  }

  double noEnergy() const { return noEnergy_; }
  double residualOf(const PreconditionedDescent& descent) const {
    return descent.gradientNorm() * residualScale_;
  }

  /// After a step on the grid begun last.
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
  }

  std::optional<StopReason> reasonToStop() const {
    if (interruptRequested()) {
      return StopReason::interrupted;
    }
    if (cycles_ >= static_cast<double>(options_.iterationLimit)) {
      return StopReason::iterationLimit;
    }
    return std::nullopt;
  }

 private:
  double share(const StrutGrid& grid) const {
    return double(grid.shape.vertexCount()) / finest_.shape.vertexCount();
  }

  const SolveOptions& options_;
  const StrutGrid& finest_;
  Clock::time_point start_ = Clock::now();
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
  DeviceGrid deviceGrid(device, grid);
  PreconditionedDescent descent(device, deviceGrid, precisionOf(device));
  progress.beginGrid(grid);
  EnergyFall fall(kCoarseTolerance, progress.noEnergy());
  while (!progress.reasonToStop() && fall.quietSteps() == 0 && descent.iterate()) {
    fall.add(descent);
    progress.add(descent, fall);
  }
  descent.finish();
  return deviceGrid.downloadPositions();
}

/// Why the descent ended.
StopReason solveFinest(PreconditionedDescent& descent, const SolveOptions& options,
                       Progress& progress) {
  EnergyFall fall(options.energyTolerance, progress.noEnergy());
  for (;;) {
    // Of long, soft grids a small residual says little: the energy must have come to rest too.
    const bool isQuiet = fall.quietSteps() > 0 || options.energyTolerance == 0;
    if (isQuiet && progress.residualOf(descent) <= options.tolerance) {
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

}  // namespace

Equilibrium solveMultigrid(const Device& device, const StrutGrid& grid, DeviceGrid& deviceGrid,
                           const SolveOptions& options) {
  const std::vector<NestedGrid> grids =
      options.startsNear ? std::vector<NestedGrid>{{grid, 1}} : nestGrids(grid);
  Progress progress(options, grids);
  if (!options.startsNear) {
    Eigen::Matrix3Xd positions = grids.front().grid.positions;
    for (std::size_t n = 0; n + 1 < grids.size(); ++n) {
      StrutGrid coarse = grids[n].grid;
      coarse.positions = withImperfection(coarse, std::move(positions));
      positions = prolong(grids[n], solveCoarse(device, coarse, progress), grids[n + 1]);
    }
    deviceGrid.uploadPositions(withImperfection(grid, std::move(positions)));
  }

  PreconditionedDescent descent(device, deviceGrid, precisionOf(device));
  progress.beginGrid(grid);
  Equilibrium result;
  result.reason = solveFinest(descent, options, progress);
  descent.finish();

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
