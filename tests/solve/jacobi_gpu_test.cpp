#include <gtest/gtest.h>

#include <cmath>

#include "solve/jacobi_solver.h"
#include "solve/reference_solver.h"
#include "tests/solve/reference_problem.h"
#include "tests/solve/sample_grids.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

class Jacobi : public DeviceTest {
 protected:
  Equilibrium solve(const StrutGrid& grid, const SolveOptions& options = {}) {
    DeviceGrid deviceGrid(device_, grid);
    JacobiSolver solver(device_, grid, deviceGrid);
    return solver.solve(options);
  }
};

TEST_F(Jacobi, StripFromFlatConverges) {
  const ReferenceProblem problem = loadReferenceProblem("strip");
  const Equilibrium result = solve(problem.grid);
  EXPECT_TRUE(result.converged) << toString(result.reason);
  EXPECT_NEAR(result.energy / problem.minimumEnergy, 1, 1e-4);
}

TEST_F(Jacobi, CircularStripBendsToItsRadius) {
  constexpr double kTheta = 0.2;
  StrutGrid grid = circularStrip(20, 3, kTheta, 0.3);
  grid.weights = TermWeights::ofAllCorners(
      0.1);  // The angular springs resist: by 17 % of the radius times their weight.
  const Equilibrium result = solve(grid);
  ASSERT_TRUE(result.converged);
  EXPECT_NEAR(stripRadius(grid.shape, result.positions) * 2 * std::sin(kTheta / 2), 1, 0.02);
}

TEST_F(Jacobi, UnitsOfLengthDoNotMatter) {
  const StrutGrid grid = bentGrid({6, 5, 3}, 2);
  StrutGrid scaled = grid;
  constexpr double kScale = 1000;
  scaled.spacing *= kScale;
  scaled.positions *= kScale;
  for (auto* rest : {&scaled.rest.u, &scaled.rest.v, &scaled.rest.w}) {
    for (double& length : *rest) {
      length *= kScale;
    }
  }
  const Equilibrium result = solve(grid);
  const Equilibrium scaledResult = solve(scaled);
  EXPECT_NEAR(scaledResult.energy / (kScale * kScale) / result.energy, 1, 1e-6);
  EXPECT_LT(largestAlignedDistance(scaledResult.positions / kScale, result.positions), 1e-3);
}

// A residual in units of the mean stiffness says nothing about struts that are much softer.
TEST_F(Jacobi, HasNotConvergedWhileSoftStrutsHaveEnergyLeft) {
  StrutGrid grid = bentGrid({8, 7, 3}, 5);
  forEachStrut(grid.shape, [&](const Strut& strut) {
    valueAt(grid.stiffness, strut) = strut.direction == Strut::Direction::w ? 910.604 : 0.00352611;
  });
  grid.weights = TermWeights::ofAllCorners(178.043);
  const double energy = solveReference(grid, {.tolerance = 1e-13}).energy;
  const auto tooHigh = [&](const Equilibrium& result) { return result.energy / energy - 1; };

  const Equilibrium byResidual = solve(grid, {.energyTolerance = 0, .iterationLimit = 20000});
  ASSERT_TRUE(byResidual.converged);
  EXPECT_GT(tooHigh(byResidual), 1e-4);

  const Equilibrium result = solve(grid, {.iterationLimit = 20000});
  if (result.converged) {
    EXPECT_LT(tooHigh(result), 1e-7);
  }
  EXPECT_LT(tooHigh(result), tooHigh(byResidual));
}

TEST_F(Jacobi, FlatGridAtRestStaysFlatAndConvergesAtOnce) {
  StrutGrid grid = bentGrid({5, 6, 2}, 4);
  forEachStrut(grid.shape, [&](const Strut& strut) {
    valueAt(grid.rest, strut) =
        (grid.positions.col(strut.to) - grid.positions.col(strut.from)).norm();
  });
  const Equilibrium result = solve(grid);
  EXPECT_TRUE(result.converged);
  EXPECT_LT((result.positions - grid.positions).norm(), 1e-6);
}

TEST_F(Jacobi, IterationLimitIsKeptAndTold) {
  const Equilibrium result = solve(bentGrid({12, 11, 3}, 5), {.iterationLimit = 64});
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.reason, StopReason::iterationLimit);
  EXPECT_EQ(result.iterations, 64);
  EXPECT_TRUE(result.positions.allFinite());
}

TEST_F(Jacobi, PositionsSurviveTheTripToTheDevice) {
  const StrutGrid grid = bentGrid({5, 4, 3}, 6);
  DeviceGrid deviceGrid(device_, grid);
  const Eigen::Matrix3Xd positions = shaken(grid.positions, 2.0, 7);
  deviceGrid.uploadPositions(positions);
  EXPECT_LT((deviceGrid.downloadPositions() - positions).cwiseAbs().maxCoeff(), 1e-9);
}

}  // namespace
}  // namespace morphgrid
