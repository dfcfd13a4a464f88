#include "benchmark/solve_run.h"

#include <cmath>
#include <limits>

#include "solve/jacobi_solver.h"
#include "solve/multigrid_solver.h"

namespace morphgrid {
namespace {

struct TimeIsUp {};

/// solve(deviceGrid, options) -> Equilibrium
template <typename Solve>
SolveRun runOnDevice(const Device& device, const StrutGrid& grid, double limit, Solve solve) {
  SolveRun run;
  MemoryUse& memory = device.memoryUse();
  memory.forgetPeak();
  const std::uint64_t heldBefore = memory.current();
  SolveOptions options;
  options.onProgress = [&](const ConvergenceSample& sample) {
    run.history.push_back(sample);
    if (sample.seconds > limit) {
      throw TimeIsUp();
    }
  };
  run.cost = costOf([&] {
    const double start = costSoFar().wall;
    DeviceGrid deviceGrid(device, grid);
    run.untilSolve = costSoFar().wall - start;
    try {
      Equilibrium equilibrium = solve(deviceGrid, options);
      run.ending = equilibrium.converged ? "converged" : toString(equilibrium.reason);
      run.history = std::move(equilibrium.history);
      run.positions = std::move(equilibrium.positions);
    } catch (const TimeIsUp&) {
      run.ending = "time limit";
    }
  });
  run.deviceBytes = memory.peak() - heldBefore;
  return run;
}

}  // namespace

double SolveRun::energy() const {
  return history.empty() ? std::numeric_limits<double>::infinity() : history.back().energy;
}

long SolveRun::iterations() const { return history.empty() ? 0 : history.back().iteration; }

std::optional<Arrival> arrivalAt(const SolveRun& run, double energy) {
  // From the end: coarser grids and lighter loads come first, and may have less energy.
  std::optional<Arrival> arrival;
  for (auto sample = run.history.rbegin(); sample != run.history.rend(); ++sample) {
    if (!(sample->energy <= energy)) {
      break;
    }
    arrival = {run.untilSolve + sample->seconds, sample->iteration};
  }
  return arrival;
}

SolveRun runMultigrid(const Device& device, const StrutGrid& grid) {
  return runOnDevice(device, grid, std::numeric_limits<double>::infinity(),
                     [&](DeviceGrid& deviceGrid, const SolveOptions& options) {
                       return solveMultigrid(device, grid, deviceGrid, options);
                     });
}

SolveRun runJacobi(const Device& device, const StrutGrid& grid, double limit) {
  return runOnDevice(device, grid, limit, [&](DeviceGrid& deviceGrid, const SolveOptions& options) {
    return JacobiSolver(device, grid, deviceGrid).solve(options);
  });
}

}  // namespace morphgrid
