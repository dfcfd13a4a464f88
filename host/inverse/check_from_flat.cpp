#include "inverse/check_from_flat.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "inverse/shape_error.h"
#include "solve/morph_course.h"

namespace morphgrid {
namespace {

constexpr int kMorphSteps = 4;
// Relative: equilibria whose energies differ by more are not the same.
constexpr double kSameEnergy = 1e-5;

}  // namespace

std::optional<FromFlat> checkFromFlat(MultigridSolver& solver, const Equilibrium& design,
                                      const Eigen::Matrix3Xd& targets, const SolveOptions& solve,
                                      Softness* softness) {
  MorphOptions morph{.steps = kMorphSteps, .solve = solve};
  morph.solve.onProgress = nullptr;
  morph.solve.onGrid = nullptr;
  double least = std::numeric_limits<double>::infinity();
  if (softness) {
    morph.onStep = [&](int, const Equilibrium& at) { least = std::min(least, softness->at(at)); };
  }
  const Equilibrium end = followMorph(solver, morph).end;
  if (solve.stopRequested()) {
    return std::nullopt;
  }
  FromFlat fromFlat{
      .sameEquilibrium =
          std::abs(end.energy - design.energy) <= kSameEnergy * std::abs(design.energy),
      .rmsPercent = computeShapeError(solver.grid().shape, end.positions, targets).rmsPercent};
  if (softness) {
    fromFlat.leastStiffness = least;
  }
  return fromFlat;
}

}  // namespace morphgrid
