#include "inverse/check_from_flat.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "inverse/shape_error.h"
#include "solve/loaded_rest.h"
#include "solve/morph_course.h"

namespace morphgrid {
namespace {

constexpr int kMorphSteps = 4;
// Of what is told as a ratio.
constexpr double kEigenvalueTolerance = 0.1;
// Relative: equilibria whose energies differ by more are not the same.
constexpr double kSameEnergy = 1e-5;

/// Where the solver's grid of bars is at rest.
double stiffnessAt(MultigridSolver& solver, const Equilibrium& equilibrium) {
  return computeSmallestEigenvalue(solver.grid(), equilibrium.positions, equilibrium.rotations,
                                   solver.preconditioner(), {.tolerance = kEigenvalueTolerance})
      .value;
}

double stiffnessOfFlatSheet(MultigridSolver& solver) {
  const StrutGrid& grid = solver.grid();
  const StrutValues rest = grid.rest;
  const Equilibrium flat{.positions = grid.positions,
                         .rotations = unturnedJoints(grid.shape.vertexCount())};
  solver.setRest(loadedRest(grid, 0));
  solver.moveTo(flat.positions, flat.rotations);
  const double stiffness = stiffnessAt(solver, flat);
  solver.setRest(rest);
  return stiffness;
}

}  // namespace

std::optional<FromFlat> checkFromFlat(MultigridSolver& solver, const Equilibrium& design,
                                      const Eigen::Matrix3Xd& targets, const SolveOptions& solve) {
  MorphOptions morph{.steps = kMorphSteps, .solve = solve};
  morph.solve.onProgress = nullptr;
  morph.solve.onGrid = nullptr;
  const bool isFrame = solver.grid().bars.has_value();
  const double flat = isFrame ? stiffnessOfFlatSheet(solver) : 0;
  double least = std::numeric_limits<double>::infinity();
  if (isFrame) {
    morph.onStep = [&](int, const Equilibrium& at) {
      least = std::min(least, stiffnessAt(solver, at));
    };
  }
  const Equilibrium end = followMorph(solver, morph).end;
  if (solve.stopRequested()) {
    return std::nullopt;
  }
  FromFlat fromFlat{
      .sameEquilibrium =
          std::abs(end.energy - design.energy) <= kSameEnergy * std::abs(design.energy),
      .rmsPercent = computeShapeError(solver.grid().shape, end.positions, targets).rmsPercent};
  if (flat > 0) {
    fromFlat.leastStiffness = least / flat;
  }
  return fromFlat;
}

}  // namespace morphgrid
