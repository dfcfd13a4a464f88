#include "inverse/softness.h"

#include <algorithm>

#include "solve/loaded_rest.h"

namespace morphgrid {
namespace {

// Of what is told as a ratio.
constexpr double kTolerance = 0.1;
// In spacings: rest lengths that have changed by less make a frame hardly softer. To judge every
// step took half of a design's time; how it ends is judged in any case.
constexpr double kLeastChange = 0.01;

}  // namespace

Softness::Softness(MultigridSolver& solver) : solver_(solver), flat_(0) {
  const StrutGrid& grid = solver.grid();
  const StrutValues rest = grid.rest;
  const Equilibrium flat{.positions = grid.positions,
                         .rotations = unturnedJoints(grid.shape.vertexCount())};
  solver.setRest(loadedRest(grid, 0));
  solver.moveTo(flat.positions, flat.rotations);
  flat_ = eigenvalueAt(flat, std::numeric_limits<double>::infinity());
  solver.setRest(rest);
}

double Softness::at(const Equilibrium& equilibrium, double enough) {
  return eigenvalueAt(equilibrium, enough * flat_) / flat_;
}

double Softness::eigenvalueAt(const Equilibrium& equilibrium, double enough) {
  // The V-cycle is set up for these positions, but only where the last motion does not tell enough.
  Preconditioner cycle;
  const auto preconditioner = [&](const Eigen::Matrix3Xd& motion) {
    if (!cycle) {
      cycle = solver_.preconditioner();
    }
    return cycle(motion);
  };
  SmallestEigenvalue found = computeSmallestEigenvalue(
      solver_.grid(), equilibrium.positions, equilibrium.rotations, preconditioner,
      {.tolerance = kTolerance, .start = softest_, .enough = enough});
  softest_ = std::move(found.motion);
  return found.value;
}

SoftnessBound::SoftnessBound(MultigridSolver& solver, double softest)
    : softness_(solver), softest_(softest), leastChange_(kLeastChange * solver.grid().spacing) {}

void SoftnessBound::startAt(const Eigen::VectorXd& rest, const Equilibrium& equilibrium) {
  judged_ = softness_.at(equilibrium, softest_);
  restJudged_ = rest;
}

bool SoftnessBound::permits(const Eigen::VectorXd& rest, const Equilibrium& equilibrium) {
  if ((rest - restJudged_).cwiseAbs().maxCoeff() < leastChange_) {
    return true;
  }
  const double softness = softness_.at(equilibrium, softest_);
  if (softness < std::min(softest_, judged_)) {
    ++refusals_;
    return false;
  }
  judged_ = softness;
  restJudged_ = rest;
  return true;
}

}  // namespace morphgrid
