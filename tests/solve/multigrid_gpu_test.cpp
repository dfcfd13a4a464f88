#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "design/build_grids.h"
#include "solve/multigrid_solver.h"
#include "solve/reference_solver.h"
#include "solve/solve_memory.h"
#include "tests/solve/reference_problem.h"
#include "tests/solve/sample_grids.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

class Multigrid : public DeviceTest {
 protected:
  Equilibrium solve(const StrutGrid& grid, const SolveOptions& options = {}) {
    DeviceGrid deviceGrid(device_, grid);
    return solveMultigrid(device_, grid, deviceGrid, options);
  }
};

/// Where the oracle comes to from an answer.
double energyDownhillFrom(const Equilibrium& found, StrutGrid grid) {
  grid.positions = found.positions;
  return solveReference(grid, {.tolerance = 1e-11, .iterationLimit = 500}).energy;
}

/// What struts and corners weigh, beside 5 for the lateral struts.
struct Extreme {
  const char* name;
  double vertical;
  double angle;
};

class MultigridExtremes : public Multigrid, public testing::WithParamInterface<Extreme> {};

TEST_P(MultigridExtremes, AgreesWithTheOracle) {
  StrutGrid grid = bentGrid({9, 7, 3}, 8);
  std::fill(grid.stiffness.w.begin(), grid.stiffness.w.end(), GetParam().vertical);
  grid.weights.angle = GetParam().angle;
  const Equilibrium found = solve(grid);
  EXPECT_TRUE(found.converged) << toString(found.reason);
  const double lowest = energyDownhillFrom(found, grid);
  EXPECT_NEAR(found.energy, lowest, 1e-6 * lowest + 1e-7);
}

INSTANTIATE_TEST_SUITE_P(Weights, MultigridExtremes,
                         testing::Values(Extreme{"SoftColumns", 5e-3, 1},
                                         Extreme{"LightCorners", 40, 5e-3},
                                         Extreme{"HeavyCorners", 40, 5e3},
                                         Extreme{"NoCorners", 40, 0}),
                         [](const auto& test) { return std::string(test.param.name); });

TEST_F(Multigrid, SymmetricGridDoesNotRestAtASaddle) {
  // Equal bends along u and v fit no surface: the symmetric answer is a saddle of the energy.
  const GridDesign design = designFromBendAngles({24, 24, 1, 0.13, 0.13, 0.13, 0.13}, 3, 0.35);
  const Weights weights;
  const auto flat = inPlaneGrid(design, weights, Scaling::normalised).positions;
  const StrutGrid grid = stackedGrid(design, weights, Scaling::normalised, flat);
  const Equilibrium found = solve(grid);
  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(found.energy / energyDownhillFrom(found, grid), 1, 1e-6);
}

TEST_F(Multigrid, SoftGridConvergesOnlyWhenItsEnergyRests) {
  // So long that the residual is small long before the energy is.
  const StrutGrid grid = circularStrip(200, 3, 0.01, 0.3);
  const Equilibrium found = solve(grid, {.tolerance = 1e-5});
  EXPECT_TRUE(found.converged);
  EXPECT_NEAR(found.energy / energyDownhillFrom(found, grid), 1, 1e-6);
}

TEST_F(Multigrid, FlatGridAtRestStaysFlatAndConvergesAtOnce) {
  StrutGrid grid = circularStrip(12, 3, 0, 0.3);
  const Equilibrium result = solve(grid);
  EXPECT_TRUE(result.converged);
  EXPECT_LT(largestAlignedDistance(result.positions, grid.positions), 1e-6);
}

/// On a device that reaches no more of a buffer than the solve needs.
Equilibrium solveWithinLeast(const StrutGrid& grid) {
  const SolveMemory needed = multigridMemory(grid.shape);
  EXPECT_LT(needed.mostBound, needed.largestBuffer);
  const Device device({.selection = "",
                       .validation = true,
                       .largestStorageBuffer = static_cast<std::uint32_t>(needed.mostBound)});
  DeviceGrid deviceGrid(device, grid);
  const Equilibrium found = solveMultigrid(device, grid, deviceGrid, {});
  EXPECT_EQ(device.validationMessages(), std::vector<std::string>{});
  return found;
}

TEST_F(Multigrid, BuffersWrittenInChunksChangeNoBit) {
  const GridDesign design = designFromBendAngles({14, 63, 1, 0.1, 0.05, 0.02, -0.03}, 2, 0.35);
  const Weights weights;
  const StrutGrid flat = inPlaneGrid(design, weights, Scaling::normalised);
  const Equilibrium inPlane = solve(flat);
  EXPECT_TRUE(inPlane.converged);
  EXPECT_EQ(solveWithinLeast(flat).positions, inPlane.positions);
  const StrutGrid stacked = stackedGrid(design, weights, Scaling::normalised, inPlane.positions);
  const Equilibrium full = solve(stacked);
  EXPECT_TRUE(full.converged);
  EXPECT_EQ(solveWithinLeast(stacked).positions, full.positions);
}

TEST_F(Multigrid, IterationLimitIsKeptAndTold) {
  const Equilibrium result = solve(bentGrid({14, 13, 3}, 5), {.iterationLimit = 3});
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.reason, StopReason::iterationLimit);
  EXPECT_LE(result.iterations, 4);
}

}  // namespace
}  // namespace morphgrid
