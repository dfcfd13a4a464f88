#include "solve/smallest_eigenvalue.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "energy/strut_energy.h"
#include "solve/preconditioners.h"
#include "tests/solve/dense_eigenvalue.h"
#include "tests/solve/reference_problem.h"
#include "tests/solve/sample_grids.h"

namespace morphgrid {
namespace {

SmallestEigenvalue compute(const StrutGrid& grid, const EigenvalueOptions& options) {
  return computeSmallestEigenvalue(grid, grid.positions, constantMatrixPreconditioner(grid),
                                   options);
}

struct Case {
  GridShape shape;
  Motions motions;
};

class SmallestEigenvalueOfShapes : public testing::TestWithParam<Case> {};

TEST_P(SmallestEigenvalueOfShapes, AgreesWithTheDenseOneAtAMinimum) {
  const StrutGrid grid = atRest(bentGrid(GetParam().shape, 8));
  const SmallestEigenvalue found =
      compute(grid, {.motions = GetParam().motions, .tolerance = 1e-6});
  EXPECT_TRUE(found.converged) << found.residual;
  const double expected = denseSmallestEigenvalue(grid, GetParam().motions);
  EXPECT_NEAR(found.value / expected, 1, 1e-5) << expected;
  EXPECT_EQ(verdictOf(found), expected > 0 ? Verdict::minimum : Verdict::saddle);
}

INSTANTIATE_TEST_SUITE_P(
    OddShapes, SmallestEigenvalueOfShapes,
    testing::Values(Case{{2, 2, 1}, Motions::inPlane}, Case{{6, 4, 1}, Motions::inPlane},
                    Case{{6, 4, 1}, Motions::inSpace}, Case{{2, 2, 2}, Motions::inSpace},
                    Case{{4, 5, 3}, Motions::inSpace}, Case{{9, 2, 2}, Motions::inSpace}));

class SmallestEigenvalueOfSheets : public testing::TestWithParam<GridShape> {};

TEST_P(SmallestEigenvalueOfSheets, IsNegativeWhereAFlatSheetWantsToBuckle) {
  const StrutGrid grid = atRest(tightRimmedSheet(GetParam()));
  const SmallestEigenvalue found = compute(grid, {.tolerance = 1e-4});
  EXPECT_EQ(verdictOf(found), Verdict::saddle);
  EXPECT_NEAR(found.value / denseSmallestEigenvalue(grid, Motions::inSpace), 1, 1e-5);
  EXPECT_NEAR(found.motion.norm(), 1, 1e-12);
  const StrutEnergy energy(grid);
  const double here = energy.evaluate(grid.positions).energy;
  for (const double step : {-0.01, 0.01}) {
    EXPECT_LT(energy.evaluate(grid.positions + step * found.motion).energy, here);
  }
  // In its plane it is at rest.
  EXPECT_EQ(verdictOf(compute(grid, {.motions = Motions::inPlane})), Verdict::minimum);
}

INSTANTIATE_TEST_SUITE_P(Layers, SmallestEigenvalueOfSheets,
                         testing::Values(GridShape{7, 7, 1}, GridShape{7, 6, 2},
                                         GridShape{8, 5, 3}));

// With the default tolerance: close to zero from either side the sign must be right.
TEST(SmallestEigenvalue, ChangesSignWhereASheetBeginsToBuckle) {
  int saddles = 0;
  for (int permille = 0; permille <= 20; permille += 2) {
    const StrutGrid grid = atRest(tightRimmedSheet({7, 6, 2}, permille / 1000.0));
    const double expected = denseSmallestEigenvalue(grid, Motions::inSpace);
    EXPECT_EQ(verdictOf(compute(grid, {})), expected > 0 ? Verdict::minimum : Verdict::saddle)
        << permille << " permille: " << expected;
    saddles += expected < 0 ? 1 : 0;
  }
  EXPECT_GT(saddles, 0);
  EXPECT_LT(saddles, 10);
}

TEST(SmallestEigenvalue, OfAReferenceAnswerIsPositive) {
  const StrutGrid grid = atRest(loadReferenceProblem("egg_chair").grid);
  const SmallestEigenvalue found = compute(grid, {});
  EXPECT_EQ(verdictOf(found), Verdict::minimum);
  EXPECT_LT(found.residual, 0.5 * found.value);
}

TEST(SmallestEigenvalue, DoesNotDependOnUnits) {
  const StrutGrid grid = atRest(bentGrid({5, 4, 2}, 1));
  StrutGrid scaled = grid;
  scaled.spacing *= 1000;
  scaled.positions *= 1000;
  scaled.weights = TermWeights::ofAllCorners(7 * grid.weights.angle);
  for (auto* values : {&scaled.rest.u, &scaled.rest.v, &scaled.rest.w}) {
    for (double& rest : *values) rest *= 1000;
  }
  for (auto* values : {&scaled.stiffness.u, &scaled.stiffness.v, &scaled.stiffness.w}) {
    for (double& stiffness : *values) stiffness *= 7;
  }
  const EigenvalueOptions options{.tolerance = 1e-6};
  EXPECT_NEAR(compute(scaled, options).value / compute(grid, options).value, 1, 1e-6);
}

TEST(SmallestEigenvalue, OfAMechanismIsUndecided) {
  StrutGrid grid = bentGrid({3, 3, 1}, 0);
  grid.weights = TermWeights::ofAllCorners(0);
  forEachStrut(grid.shape, [&](const Strut& strut) { valueAt(grid.rest, strut) = 1; });
  const SmallestEigenvalue found = compute(grid, {.motions = Motions::inPlane});
  EXPECT_NEAR(found.value, 0, 1e-12);
  EXPECT_EQ(verdictOf(found), Verdict::undecided);
}

TEST(SmallestEigenvalue, RefusesAPreconditionerThatGivesNoNumbers) {
  const StrutGrid grid = bentGrid({3, 3, 2}, 0);
  const auto broken = [](const Eigen::Matrix3Xd& right) { return Eigen::Matrix3Xd(right / 0.0); };
  EXPECT_THROW(computeSmallestEigenvalue(grid, grid.positions, broken), DeviceError);
}

TEST(SmallestEigenvalue, IterationLimitIsKeptAndLeavesItUndecided) {
  const SmallestEigenvalue found =
      compute(atRest(bentGrid({9, 8, 3}, 1)), {.tolerance = 1e-9, .iterationLimit = 2});
  EXPECT_FALSE(found.converged);
  EXPECT_EQ(found.iterations, 2);
  EXPECT_EQ(verdictOf(found), Verdict::undecided);
}

}  // namespace
}  // namespace morphgrid
