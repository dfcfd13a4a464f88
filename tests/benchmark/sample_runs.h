#pragma once
#include <initializer_list>

#include "benchmark/solve_comparison.h"

namespace morphgrid {

/// One sample a second, one iteration each.
SolveRun runWith(std::initializer_list<double> energies);

/// Converged, after wall time `seconds` and half as much CPU time.
SolveRun runOf(double seconds, std::initializer_list<double> energies);

}  // namespace morphgrid
