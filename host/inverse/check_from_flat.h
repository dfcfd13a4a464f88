#pragma once
#include <functional>
#include <optional>

#include "inverse/softness.h"
#include "solve/multigrid_solver.h"

namespace morphgrid {

/// Where the chosen design gets by a slow morph from the printed sheet, see followMorph().
struct FromFlat {
  bool sameEquilibrium;  ///< Whether it is that of the inverse design.
  double rmsPercent;     ///< Distance to the target, see ShapeError.
  /// Of frames: the least Softness over the steps.
  std::optional<double> leastStiffness;
  bool isSettled = true;  ///< Whether every step came to rest within its cycles.
  long cycles = 0;        ///< Of all steps.
  double seconds = 0;
};

/// Told how far the check is: a step from 1 on, of how many, seconds since it began.
using FromFlatProgress = std::function<void(int step, int steps, double seconds)>;

/// What is printed starts flat, not at the last design's equilibrium. The solver's grid has the
/// design's rest lengths; targets: 3 x layerVertexCount; solve: of the last step, but for its limit
/// of iterations: each step has 1000 cycles at most. Nothing when the user has asked to stop.
/// softness: of frames, else null. onProgress may be empty. The solver then stands where the morph
/// ended.
std::optional<FromFlat> checkFromFlat(MultigridSolver& solver, const Equilibrium& design,
                                      const Eigen::Matrix3Xd& targets, const SolveOptions& solve,
                                      Softness* softness, const FromFlatProgress& onProgress);

}  // namespace morphgrid
