#include "benchmark/solve_comparison.h"

#include <algorithm>
#include <limits>

namespace morphgrid {
namespace {

SolveRun run(const Device& device, const StrutGrid& grid, const std::string& method, double limit) {
  if (method == "multigrid") {
    return runMultigrid(device, grid);
  }
  return method == "jacobi" ? runJacobi(device, grid, limit) : runReference(grid, limit);
}

std::vector<Entrant> entrantsOf(const StrutGrid& grid, const std::vector<std::string>& methods) {
  std::vector<Entrant> entrants;
  for (const std::string& method : methods) {
    entrants.push_back({method, method, grid});
  }
  return entrants;
}

template <typename Figure>
double medianOf(const std::vector<SolveRun>& runs, Figure figure) {
  std::vector<double> values;
  for (const SolveRun& each : runs) {
    values.push_back(figure(each));
  }
  return median(std::move(values));
}

}  // namespace

bool MethodRuns::converged() const {
  return std::all_of(runs.begin(), runs.end(),
                     [](const SolveRun& each) { return each.ending == "converged"; });
}

double MethodRuns::wallSeconds() const {
  return medianOf(runs, [](const SolveRun& each) { return each.cost.wall; });
}

double MethodRuns::cpuSeconds() const {
  return medianOf(runs, [](const SolveRun& each) { return each.cost.cpu; });
}

double MethodRuns::energy() const {
  double least = std::numeric_limits<double>::infinity();
  for (const SolveRun& each : runs) {
    least = std::min(least, each.energy());
  }
  return least;
}

std::optional<Arrival> MethodRuns::arrival(double leastEnergy) const {
  std::vector<double> seconds;
  long iterations = 0;
  for (const SolveRun& each : runs) {
    const auto arrived = arrivalAt(each, leastEnergy * (1 + kEnergyError));
    if (!arrived) {
      return std::nullopt;
    }
    seconds.push_back(arrived->seconds);
    iterations = arrived->iterations;  // The same in all.
  }
  return Arrival{median(std::move(seconds)), iterations};
}

double Comparison::leastEnergy() const {
  double least = std::numeric_limits<double>::infinity();
  for (const MethodRuns& one : full) {
    least = std::min(least, one.energy());
  }
  return least;
}

const MethodRuns* Comparison::find(const std::string& method) const {
  const auto found = std::find_if(full.begin(), full.end(),
                                  [&](const MethodRuns& one) { return one.method == method; });
  return found == full.end() ? nullptr : &*found;
}

std::vector<MethodRuns> takeTurns(const Device& device, const std::vector<Entrant>& entrants,
                                  const ComparisonOptions& options) {
  std::vector<MethodRuns> all;
  for (const Entrant& entrant : entrants) {
    all.push_back({entrant.name, {}});
  }
  for (int round = 0; round < options.rounds; ++round) {
    for (std::size_t n = 0; n < entrants.size(); ++n) {
      double spent = 0;
      for (const SolveRun& earlier : all[n].runs) {
        spent += earlier.cost.wall;
      }
      if (spent < options.seconds) {
        all[n].runs.push_back(run(device, entrants[n].grid, entrants[n].method, options.peerLimit));
        all[n].runs.back().positions.resize(3, 0);
      }
    }
  }
  return all;
}

Comparison compareMethods(const Device& device, const Problem& problem,
                          const ComparisonOptions& options) {
  const StrutGrid inPlane = problem.inPlane();
  const StrutGrid stacked = problem.stacked(runMultigrid(device, inPlane).positions);
  std::vector<std::string> inPlaneMethods = options.methods;
  std::erase(inPlaneMethods, "jacobi");
  return {problem.name, stacked.shape,
          takeTurns(device, entrantsOf(inPlane, inPlaneMethods), options),
          takeTurns(device, entrantsOf(stacked, options.methods), options)};
}

}  // namespace morphgrid
