#include "solve/reference_solver.h"

#include <gtest/gtest.h>

#include <cmath>

#include "energy/strut_energy.h"
#include "tests/solve/reference_problem.h"
#include "tests/solve/sample_grids.h"

namespace morphgrid {
namespace {

class ReferenceAnswers : public testing::TestWithParam<const char*> {};

TEST_P(ReferenceAnswers, MinimumEnergyIsReached) {
  const ReferenceProblem problem = loadReferenceProblem(GetParam());
  SolveOptions options;
  options.tolerance = 1e-11;
  const Equilibrium result = solveReference(problem.grid, options);
  EXPECT_NEAR(result.energy / problem.minimumEnergy, 1, 1e-8);
}

INSTANTIATE_TEST_SUITE_P(ShapeOp, ReferenceAnswers,
                         testing::Values("strip", "egg_chair_in_plane", "egg_chair",
                                         "saddle_patch"),
                         [](const auto& test) { return std::string(test.param); });

TEST(ReferenceSolver, CircularStripBendsToItsRadius) {
  constexpr double kTheta = 0.2;
  StrutGrid grid = circularStrip(20, 3, kTheta, 0.3);
  grid.weights = TermWeights::ofAllCorners(
      1e-3);  // The angular springs resist: by 17 % of the radius times their weight.
  const Equilibrium result = solveReference(grid, {.tolerance = 1e-11});
  EXPECT_NEAR(stripRadius(grid.shape, result.positions) * 2 * std::sin(kTheta / 2), 1, 1e-3);
}

TEST(ReferenceSolver, IterationLimitIsKeptAndTold) {
  const Equilibrium result = solveReference(bentGrid({8, 7, 3}, 1), {.iterationLimit = 3});
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.reason, StopReason::iterationLimit);
  EXPECT_EQ(result.iterations, 3);
}

}  // namespace
}  // namespace morphgrid
