#include "tests/benchmark/sample_runs.h"

namespace morphgrid {

SolveRun runWith(std::initializer_list<double> energies) {
  SolveRun run;
  for (const double energy : energies) {
    const long iteration = static_cast<long>(run.history.size()) + 1;
    run.history.push_back({iteration, energy, 0, static_cast<double>(iteration)});
  }
  return run;
}

SolveRun runOf(double seconds, std::initializer_list<double> energies) {
  SolveRun run = runWith(energies);
  run.cost = {seconds, seconds / 2};
  run.ending = "converged";
  return run;
}

}  // namespace morphgrid
