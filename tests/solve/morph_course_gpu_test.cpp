#include "solve/morph_course.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "tests/solve/sample_grids.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

class Morph : public DeviceTest {};

TEST_F(Morph, StripRollsUpInProportionToItsShrink) {
  constexpr double kTheta = 0.2;
  constexpr int kSteps = 4;
  StrutGrid grid = circularStrip(20, 3, kTheta, 0.3);
  grid.weights = TermWeights::ofAllCorners(1e-3);
  MultigridSolver solver(device_, grid);
  const MorphCourse course =
      followMorph(solver, {.steps = kSteps, .solve = {.energyTolerance = 1e-12}});
  EXPECT_EQ(course.unconverged, 0);
  ASSERT_EQ(course.positions.size(), kSteps + 1);
  EXPECT_EQ(course.positions.front(), grid.positions);
  EXPECT_EQ(course.positions.back(), course.end.positions);
  // Eq. 25: layers differ in proportion to sin(theta / 2) = L0 / (2 radius).
  const double radius = 1 / (2 * std::sin(kTheta / 2));
  for (int step = 1; step <= kSteps; ++step) {
    EXPECT_NEAR(stripRadius(grid.shape, course.positions[step]) * step / kSteps, radius,
                0.02 * radius)
        << step;
  }
}

TEST_F(Morph, EndsWhereTheGridRests) {
  const StrutGrid grid = bentGrid({9, 7, 3}, 3);
  std::vector<int> told;
  MultigridSolver solver(device_, grid);
  const MorphCourse course = followMorph(
      solver, {.steps = 3, .onStep = [&](int step, const Equilibrium&) { told.push_back(step); }});
  const Equilibrium direct = solver.solve({});
  EXPECT_NEAR(course.end.energy, direct.energy, 1e-6 * direct.energy);
  EXPECT_THAT(told, testing::ElementsAre(1, 2, 3));
}

TEST_F(Morph, StepsThatDoNotConvergeAreCounted) {
  MultigridSolver solver(device_, bentGrid({9, 7, 3}, 3));
  const MorphCourse course = followMorph(solver, {.steps = 2, .solve = {.iterationLimit = 1}});
  EXPECT_EQ(course.unconverged, 2);
  EXPECT_EQ(course.positions.size(), 3);
}

}  // namespace
}  // namespace morphgrid
