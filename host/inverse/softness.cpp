#include "inverse/softness.h"

#include "solve/loaded_rest.h"

namespace morphgrid {
namespace {

// Of what is told as a ratio.
constexpr double kTolerance = 0.1;

}  // namespace

Softness::Softness(MultigridSolver& solver) : solver_(solver), flat_(0) {
  const StrutGrid& grid = solver.grid();
  const StrutValues rest = grid.rest;
  const Equilibrium flat{.positions = grid.positions,
                         .rotations = unturnedJoints(grid.shape.vertexCount())};
  solver.setRest(loadedRest(grid, 0));
  solver.moveTo(flat.positions, flat.rotations);
  flat_ = eigenvalueAt(flat);
  solver.setRest(rest);
}

double Softness::at(const Equilibrium& equilibrium) { return eigenvalueAt(equilibrium) / flat_; }

double Softness::eigenvalueAt(const Equilibrium& equilibrium) {
  SmallestEigenvalue found = computeSmallestEigenvalue(
      solver_.grid(), equilibrium.positions, equilibrium.rotations, solver_.preconditioner(),
      {.tolerance = kTolerance, .start = softest_});
  softest_ = std::move(found.motion);
  return found.value;
}

}  // namespace morphgrid
