#include "solve/morph_course.h"

#include <algorithm>
#include <cassert>

#include "solve/device_grid.h"
#include "solve/imperfection.h"
#include "solve/loaded_rest.h"
#include "solve/multigrid_solver.h"

namespace morphgrid {
namespace {

// On the way nobody sees less.
constexpr double kEnergyToleranceOnTheWay = 1e-6;

}  // namespace

MorphCourse followMorph(const Device& device, const StrutGrid& grid, const MorphOptions& options) {
  assert(options.steps >= 1);
  DeviceGrid deviceGrid(device, grid);
  StrutGrid loaded = grid;
  SolveOptions solve = options.solve;
  solve.startsNear = true;
  solve.energyTolerance = std::max(solve.energyTolerance, kEnergyToleranceOnTheWay);
  MorphCourse course;
  course.positions.push_back(grid.positions);
  for (int step = 1; step <= options.steps && !solve.stopRequested(); ++step) {
    loaded.rest = loadedRest(grid, static_cast<double>(step) / options.steps);
    deviceGrid.uploadRest(loaded.rest);
    // A symmetric grid may lose its balance at any step: it must find the way out.
    deviceGrid.uploadPositions(withImperfection(loaded, course.positions.back()));
    if (step == options.steps) {
      solve.energyTolerance = options.solve.energyTolerance;
    }
    course.end = solveMultigrid(device, loaded, deviceGrid, solve);
    course.unconverged += course.end.converged ? 0 : 1;
    course.positions.push_back(course.end.positions);
    if (options.onStep) {
      options.onStep(step);
    }
  }
  return course;
}

}  // namespace morphgrid
