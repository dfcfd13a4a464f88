#include "solve/multigrid_solver.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "core/interrupt.h"
#include "solve/energy.h"
#include "solve/nested_grids.h"
#include "solve/preconditioned_descent.h"

namespace morphgrid {
namespace {

using Clock = std::chrono::steady_clock;

// A coarser grid is solved to this share of its energy: more would not spare the finer one a cycle.
constexpr double kCoarseTolerance = 1e-4;

/// What has happened since solveMultigrid() began.
class Progress {
 public:
  Progress(const SolveOptions& options, const StrutGrid& finest)
      : options_(options), energyScale_(finest.spacing * finest.spacing) {}

  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  double cycles() const { return cycles_; }
  std::vector<ConvergenceSample>& history() { return history_; }

  /// share: of the finest grid's vertices.
  void add(double share, double energy, double residual) {
    cycles_ += share;
    if (!std::isfinite(energy) || !std::isfinite(residual)) {
      throw DeviceError(
          fmt::format("the solve left the range of numbers at cycle {:.0f}", cycles_));
    }
    history_.push_back(
        {static_cast<long>(std::ceil(cycles_)), energy * energyScale_, residual, seconds()});
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
  const SolveOptions& options_;
  double energyScale_;
  Clock::time_point start_ = Clock::now();
  double cycles_ = 0;
  std::vector<ConvergenceSample> history_;
};

/// What turns a gradient's norm into a residual, see StrutEnergy::residual().
double residualScale(const StrutEnergy& energy, const GridShape& shape) {
  return 1 / (2 * energy.constraintWeights().mean() * std::sqrt(double(shape.vertexCount())));
}

Precision precisionOf(const Device& device) {
  return device.hasFloat64() ? Precision::precise : Precision::single;
}

/// Positions of a coarser grid's equilibrium, about.
Eigen::Matrix3Xd solveCoarse(const Device& device, const StrutGrid& grid, double share,
                             Progress& progress) {
  DeviceGrid deviceGrid(device, grid);
  PreconditionedDescent descent(device, deviceGrid, precisionOf(device));
  const StrutEnergy energy(grid);
  const double scale = residualScale(energy, grid.shape);
  while (!progress.reasonToStop() &&
         descent.predictedDecrease() > kCoarseTolerance * descent.energy() && descent.iterate()) {
    progress.add(share, descent.energy() * grid.spacing * grid.spacing,
                 descent.gradientNorm() * scale);
  }
  descent.finish();
  return deviceGrid.downloadPositions();
}

}  // namespace

Equilibrium solveMultigrid(const Device& device, const StrutGrid& grid, DeviceGrid& deviceGrid,
                           const SolveOptions& options) {
  Progress progress(options, grid);
  const std::vector<NestedGrid> grids = nestGrids(grid);
  Eigen::Matrix3Xd positions = grids.front().grid.positions;
  for (std::size_t n = 0; n + 1 < grids.size(); ++n) {
    StrutGrid coarse = grids[n].grid;
    coarse.positions = positions;
    const double share = double(coarse.shape.vertexCount()) / grid.shape.vertexCount();
    positions = prolong(grids[n], solveCoarse(device, coarse, share, progress), grids[n + 1]);
  }
  deviceGrid.uploadPositions(positions);

  PreconditionedDescent descent(device, deviceGrid, precisionOf(device));
  const StrutEnergy energy(grid);
  const double scale = residualScale(energy, grid.shape);
  Equilibrium result;
  std::optional<StopReason> reason;
  while (!(reason = progress.reasonToStop())) {
    if (descent.gradientNorm() * scale <= options.tolerance) {
      break;
    }
    if (!descent.iterate()) {
      reason = StopReason::stagnated;
      break;
    }
    progress.add(1, descent.energy() * grid.spacing * grid.spacing / (grid.spacing * grid.spacing),
                 descent.gradientNorm() * scale);
  }
  descent.finish();

  result.positions = deviceGrid.downloadPositions();
  const StrutEnergy::Value value = energy.evaluate(result.positions);
  result.energy = value.energy;
  result.residual = energy.residual(value.gradient);
  // The device may see a slightly other residual than the host in double: the host decides.
  result.converged = result.residual <= options.tolerance;
  result.reason = result.converged ? StopReason::residual : reason.value_or(StopReason::stagnated);
  result.iterations = static_cast<long>(std::ceil(progress.cycles()));
  result.seconds = progress.seconds();
  result.history = std::move(progress.history());
  result.history.push_back({result.iterations, result.energy, result.residual, result.seconds});
  return result;
}

}  // namespace morphgrid
