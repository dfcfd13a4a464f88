#pragma once
#include <vector>

#include "benchmark/problem.h"
#include "benchmark/solve_run.h"

namespace morphgrid {

/// What is measured of every problem.
struct ComparisonOptions {
  std::vector<std::string> methods{"multigrid", "reference", "jacobi"};
  int rounds = 5;          ///< At most; medians count.
  double seconds = 10;     ///< A method that has run for as long in all is not repeated.
  double peerLimit = 120;  ///< Seconds after which one solve of a peer of multigrid ends.
};

/// The solves of one method, all of the same problem.
struct MethodRuns {
  std::string method;  ///< Or the entrant's name.
  std::vector<SolveRun> runs;

  bool converged() const;
  double wallSeconds() const;  ///< Medians, of whole solves.
  double cpuSeconds() const;
  double energy() const;  ///< The least that was reached.
  /// To within kEnergyError of the least energy that is known; empty when a run does not get there.
  std::optional<Arrival> arrival(double leastEnergy) const;
};

/// One that takes its turn: a method on a grid, which must outlive it.
struct Entrant {
  std::string name;
  std::string method;  ///< multigrid, reference or jacobi
  const StrutGrid& grid;
};

/// Solves of each entrant, which take turns so that a noisy neighbour meets all. Positions are
/// dropped. Throws DeviceError when the device fails.
std::vector<MethodRuns> takeTurns(const Device& device, const std::vector<Entrant>& entrants,
                                  const ComparisonOptions& options);

/// Relative.
constexpr double kEnergyError = 1e-6;

struct Comparison {
  std::string name;
  GridShape shape;
  std::vector<MethodRuns> inPlane;  ///< Without jacobi.
  std::vector<MethodRuns> full;     ///< From the stacked, flat grid; the same for all methods.

  double leastEnergy() const;
  const MethodRuns* find(const std::string& method) const;  ///< In `full`; null when not run.
};

/// Solves both stages by all methods, which take turns. Throws DeviceError when the device fails.
Comparison compareMethods(const Device& device, const Problem& problem,
                          const ComparisonOptions& options);

}  // namespace morphgrid
