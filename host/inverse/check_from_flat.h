#pragma once
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
};

/// What is printed starts flat, not at the last design's equilibrium. The solver's grid has the
/// design's rest lengths; targets: 3 x layerVertexCount; solve: of the last step. Nothing when the
/// user has asked to stop. softness: of frames, else null. The solver then stands where the morph
/// ended.
std::optional<FromFlat> checkFromFlat(MultigridSolver& solver, const Equilibrium& design,
                                      const Eigen::Matrix3Xd& targets, const SolveOptions& solve,
                                      Softness* softness);

}  // namespace morphgrid
