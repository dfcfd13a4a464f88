#include "solve/reference_solver.h"

#include <gtest/gtest.h>

#include "solve/energy.h"
#include "tests/solve/reference_problem.h"

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

}  // namespace
}  // namespace morphgrid
