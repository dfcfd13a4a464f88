#pragma once
#include <optional>

#include "solve/multigrid_solver.h"

namespace morphgrid {

/// Below this share of the flat sheet's smallest eigenvalue a grid is judged to be near buckling
/// (a judgement, not measured).
inline constexpr double kSoftest = 0.3;

/// How soft a grid of welded bars is: the smallest eigenvalue (see SmallestEigenvalue) over that of
/// the flat sheet. Near 0 it is about to buckle.
class Softness {
 public:
  /// The solver's grid has bars; it is brought to the flat sheet and stays there, its rest lengths
  /// as they were. Keeps a reference.
  explicit Softness(MultigridSolver& solver);

  /// Where the solver stands, at rest.
  double at(const Equilibrium& equilibrium);

 private:
  double eigenvalueAt(const Equilibrium& equilibrium);

  MultigridSolver& solver_;
  Eigen::Matrix3Xd softest_;  ///< The motion that was found last: the next one is much alike.
  double flat_;
};

}  // namespace morphgrid
