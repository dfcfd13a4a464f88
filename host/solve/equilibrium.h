#pragma once
#include <Eigen/Core>
#include <functional>
#include <string>
#include <vector>

namespace morphgrid {

enum class StopReason {
  residual,        ///< The residual fell below the tolerance: converged.
  iterationLimit,  ///< The limit came first.
  stagnated,       ///< The residual no longer falls at the precision of the positions.
  interrupted,     ///< The user asked to stop.
};

/// "residual", "iteration limit", "stagnated", "interrupted".
std::string toString(StopReason reason);

struct ConvergenceSample {
  long iteration;
  double energy;
  double residual;
  double seconds;  ///< Since the stage began.
};

struct SolveOptions {
  double tolerance = 1e-9;       ///< Bound on the residual, see computeResidual(), > 0
  long iterationLimit = 200000;  ///< >= 0
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
};

}  // namespace morphgrid
