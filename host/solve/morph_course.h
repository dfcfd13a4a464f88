#pragma once
#include <functional>
#include <vector>

#include "solve/multigrid_solver.h"

namespace morphgrid {

struct MorphOptions {
  int steps = 48;      ///< >= 1
  SolveOptions solve;  ///< For the last step; those before it are solved less tightly.
  /// Called after each step, from 1 on, with where it ended; may be empty.
  std::function<void(int step, const Equilibrium& at)> onStep;
};

/// How a grid gets from where it was printed to where it comes to rest.
struct MorphCourse {
  /// 3 x vertexCount each, in the scene's unit of length: as printed, then after each step. Fewer
  /// when the user asked to stop.
  std::vector<Eigen::Matrix3Xd> positions;
  Equilibrium end;      ///< That of the last step.
  int unconverged = 0;  ///< Steps that did not converge.
};

/// The course of a slow morph, in which the material is at rest at any time: all struts of the
/// solver's grid shrink in equal shares from their printed lengths, at grid().positions, to
/// grid().rest, and every equilibrium is sought from the one before, so that the grid stays on its
/// branch where it has several. Throws DeviceError when the device fails.
MorphCourse followMorph(MultigridSolver& solver, const MorphOptions& options);

}  // namespace morphgrid
