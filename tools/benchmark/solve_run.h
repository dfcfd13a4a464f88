#pragma once
#include <optional>

#include "benchmark/cost.h"
#include "gpu/device.h"
#include "grid/strut_grid.h"
#include "solve/equilibrium.h"

namespace morphgrid {

/// One solve, and what it took.
struct SolveRun {
  Cost cost{};                    ///< From the grid in the host's memory to the equilibrium there.
  double untilSolve = 0;          ///< Seconds of it that passed before history begins to count.
  std::string ending;             ///< "converged", another StopReason, or what cut it short.
  std::uint64_t deviceBytes = 0;  ///< Most device memory held at a time, beyond that held before.
  std::vector<ConvergenceSample> history;
  Eigen::Matrix3Xd positions;  ///< Empty when it was cut short, or of `reference`.

  double energy() const;
  long iterations() const;
};

/// When, and after how many iterations, the energy had fallen to a bound for good.
struct Arrival {
  double seconds;
  long iterations;
};
std::optional<Arrival> arrivalAt(const SolveRun& run, double energy);

/// Solvers on the device, with their default options. The compiled kernels stay with the device:
/// a first run warms up. After `limit` seconds the solve is cut short.
SolveRun runMultigrid(const Device& device, const StrutGrid& grid);
SolveRun runJacobi(const Device& device, const StrutGrid& grid, double limit);

/// The peer on the CPU, solveReference() or, of frames, solveFrame(): in a process of its own,
/// which may run out of memory and is killed after `limit` seconds, wherever it is.
SolveRun runReference(const StrutGrid& grid, double limit);

}  // namespace morphgrid
