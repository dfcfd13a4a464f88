#include "solve/morph_course.h"

#include <algorithm>
#include <cassert>

#include "solve/imperfection.h"
#include "solve/loaded_rest.h"

namespace morphgrid {
namespace {

// On the way nobody sees less.
constexpr double kEnergyToleranceOnTheWay = 1e-6;

}  // namespace

MorphCourse followMorph(MultigridSolver& solver, const MorphOptions& options) {
  assert(options.steps >= 1);
  const StrutGrid grid = solver.grid();
  SolveOptions solve = options.solve;
  solve.startsNear = true;
  solve.energyTolerance = std::max(solve.energyTolerance, kEnergyToleranceOnTheWay);
  MorphCourse course;
  course.positions.push_back(grid.positions);
  for (int step = 1; step <= options.steps && !solve.stopRequested(); ++step) {
    solver.setRest(loadedRest(grid, static_cast<double>(step) / options.steps));
    // A symmetric grid may lose its balance at any step: it must find the way out.
    solver.moveTo(withImperfection(solver.grid(), course.positions.back()));
    if (step == options.steps) {
      solve.energyTolerance = options.solve.energyTolerance;
    }
    course.end = solver.solve(solve);
    course.unconverged += course.end.converged ? 0 : 1;
    course.positions.push_back(course.end.positions);
    if (options.onStep) {
      options.onStep(step, course.end);
    }
  }
  solver.setRest(grid.rest);
  return course;
}

}  // namespace morphgrid
