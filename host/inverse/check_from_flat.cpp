#include "inverse/check_from_flat.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>

#include "inverse/shape_error.h"
#include "solve/morph_course.h"

namespace morphgrid {
namespace {

constexpr int kMorphSteps = 4;
// A step takes tens where the grid is well; where it is not, thousands tell no more.
constexpr long kMostCycles = 1000;
// Relative: equilibria whose energies differ by more are not the same.
constexpr double kSameEnergy = 1e-5;

}  // namespace

std::optional<FromFlat> checkFromFlat(MultigridSolver& solver, const Equilibrium& design,
                                      const Eigen::Matrix3Xd& targets, const SolveOptions& solve,
                                      Softness* softness, const FromFlatProgress& onProgress) {
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  MorphOptions morph{.steps = kMorphSteps, .solve = solve};
  morph.solve.iterationLimit = std::min(solve.iterationLimit, kMostCycles);
  morph.solve.onGrid = nullptr;
  int step = 1;
  long cycles = 0;
  morph.solve.onProgress = [&](const ConvergenceSample&) {
    if (onProgress) onProgress(step, kMorphSteps, seconds());
  };
  double least = std::numeric_limits<double>::infinity();
  morph.onStep = [&](int done, const Equilibrium& at) {
    step = done + 1;
    cycles += at.iterations;
    if (softness) least = std::min(least, softness->at(at));
  };
  const MorphCourse course = followMorph(solver, morph);
  const Equilibrium& end = course.end;
  if (solve.stopRequested()) {
    return std::nullopt;
  }
  FromFlat fromFlat{
      .sameEquilibrium =
          std::abs(end.energy - design.energy) <= kSameEnergy * std::abs(design.energy),
      .rmsPercent = computeShapeError(solver.grid().shape, end.positions, targets).rmsPercent,
      .leastStiffness = std::nullopt,
      .isSettled = course.unconverged == 0,
      .cycles = cycles};
  if (softness) {
    fromFlat.leastStiffness = least;
  }
  fromFlat.seconds = seconds();
  return fromFlat;
}

}  // namespace morphgrid
