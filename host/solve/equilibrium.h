#pragma once
#include <Eigen/Core>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "solve/smallest_eigenvalue.h"

namespace morphgrid {

enum class StopReason {
  residual,        ///< The residual fell below the tolerance: converged.
  energy,          ///< The energy has no more to lose than the energy tolerance: converged.
  iterationLimit,  ///< The limit came first.
  stagnated,       ///< The residual no longer falls at the precision of the positions.
  interrupted,     ///< The user asked to stop.
};

/// "residual", "energy", "iteration limit", "stagnated", "interrupted".
std::string toString(StopReason reason);

struct ConvergenceSample {
  long iteration;
  double energy;
  double residual;
  double seconds;           ///< Since the stage began.
  double gridShare = 1;     ///< Vertices over those of the grid: below 1 on coarser grids.
  double secondsLeft = -1;  ///< Estimate; negative: unknown.
};

struct SolveOptions {
  double tolerance = 1e-9;  ///< Bound on the residual, see StrutEnergy::residual(), > 0
  /// Multigrid also stops when three steps in a row could not have lowered the energy by more than
  /// this share of it; >= 0, 0: never.
  double energyTolerance = 1e-9;
  long iterationLimit = 200000;  ///< >= 0
  /// Multigrid starts where the device grid's positions are, near the answer, without coarser
  /// grids.
  bool startsNear = false;
  /// Called now and then with the newest sample; may be empty.
  std::function<void(const ConvergenceSample&)> onProgress;
};

/// Where a grid comes to rest. Energy and residual are recomputed in double from `positions`.
struct Equilibrium {
  Eigen::Matrix3Xd positions;  ///< 3 x vertexCount, in the scene's unit of length.
  long iterations = 0;
  bool converged = false;
  StopReason reason = StopReason::iterationLimit;
  double residual = 0;
  double energy = 0;
  double seconds = 0;
  std::vector<ConvergenceSample> history;
  std::optional<SmallestEigenvalue> smallestEigenvalue;  ///< On request.
};

/// What the smallest eigenvalue says; undecided without one, and where the solver has not
/// converged: no equilibrium is neither minimum nor saddle.
Verdict verdictOf(const Equilibrium& equilibrium);

}  // namespace morphgrid
