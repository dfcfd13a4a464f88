#pragma once
#include <limits>

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

  /// Where the solver stands, at rest; within a tenth where it is no more than `enough`.
  double at(const Equilibrium& equilibrium,
            double enough = std::numeric_limits<double>::infinity());

 private:
  double eigenvalueAt(const Equilibrium& equilibrium, double enough);

  MultigridSolver& solver_;
  Eigen::Matrix3Xd softest_;  ///< The motion that was found last: the next one is much alike.
  double flat_;
};

/// Refuses steps of an inverse design that bring a frame near buckling.
class SoftnessBound {
 public:
  /// softest: a step may leave no less, unless there was less before. The solver is brought to the
  /// flat sheet. Keeps a reference.
  SoftnessBound(MultigridSolver& solver, double softest);

  /// Where the design starts; rest: its lateral rest lengths, see LateralRest. The solver stands
  /// there.
  void startAt(const Eigen::VectorXd& rest, const Equilibrium& equilibrium);
  /// Whether the design may go on there, where the solver stands; counted where it may not. Rest
  /// lengths that have hardly changed since it was judged last are not judged again.
  bool permits(const Eigen::VectorXd& rest, const Equilibrium& equilibrium);

  int refusals() const { return refusals_; }
  Softness& softness() { return softness_; }

 private:
  Softness softness_;
  double softest_;
  double leastChange_;  ///< Of a rest length.
  double judged_ = 0;   ///< Softness at restJudged_.
  Eigen::VectorXd restJudged_;
  int refusals_ = 0;
};

}  // namespace morphgrid
