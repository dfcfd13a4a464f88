#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
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
  grid.weights = TermWeights::ofAllCorners(GetParam().angle);
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

/// A grid of the shape of bentGrid(shape, 8), with nothing else in common.
StrutGrid otherGrid(const GridShape& shape) {
  StrutGrid grid = bentGrid(shape, 9);
  grid.spacing = 2;
  grid.weights = TermWeights::ofAllCorners(3);
  grid.positions.array() = 2 * grid.positions.array() + 5;
  for (std::vector<double>* lengths : {&grid.rest.u, &grid.rest.v, &grid.rest.w}) {
    for (double& length : *lengths) length *= 2;
  }
  std::fill(grid.stiffness.w.begin(), grid.stiffness.w.end(), 10);
  return grid;
}

TEST_F(Multigrid, AnotherGridComesToWhatANewSolverWouldGive) {
  const GridShape shape{12, 10, 3};
  MultigridSolver solver(device_, bentGrid(shape, 8));
  const Equilibrium first = solver.solve({});
  EXPECT_TRUE(first.converged);
  StrutGrid uneven = otherGrid(shape);
  uneven.stiffness.u.front() = 4;  // Other kernels.
  for (const StrutGrid& grid : {otherGrid(shape), uneven, bentGrid(shape, 8)}) {
    solver.setGrid(grid);
    MultigridSolver fresh(device_, grid);
    const Equilibrium expected = fresh.solve({});
    EXPECT_TRUE(expected.converged);
    const Equilibrium again = solver.solve({});
    EXPECT_EQ(again.positions, expected.positions);
    EXPECT_EQ(again.iterations, expected.iterations);
  }
  EXPECT_EQ(solver.solve({}).positions, first.positions);
}

TEST_F(Multigrid, AnotherGridNearItsAnswerDoesTooAndAnswersToForces) {
  const GridShape shape{12, 10, 3};
  MultigridSolver solver(device_, bentGrid(shape, 8));
  const Eigen::Matrix3Xd near = solver.solve({}).positions;
  StrutGrid grid = bentGrid(shape, 8);
  grid.weights = TermWeights::ofAllCorners(2);
  Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, shape.vertexCount());
  forces(2, 0) = forces(2, 1) = 1;
  forces(2, 2) = -2;
  solver.solveAdjoint(forces);
  MultigridSolver fresh(device_, grid);
  solver.setGrid(grid);
  for (MultigridSolver* each : {&solver, &fresh}) {
    each->moveTo(near);
  }
  const SolveOptions options{.startsNear = true};
  EXPECT_EQ(solver.solve(options).positions, fresh.solve(options).positions);
  EXPECT_EQ(solver.solveAdjoint(forces).lambda, fresh.solveAdjoint(forces).lambda);
}

TEST_F(Multigrid, ABrokenGridIsRefused) {
  const GridShape shape{4, 4, 2};
  MultigridSolver solver(device_, bentGrid(shape, 8));
  StrutGrid broken = bentGrid(shape, 8);
  broken.rest.u.front() = -1;
  EXPECT_THROW(solver.setGrid(broken), InputError);
}

TEST_F(Multigrid, IterationLimitIsKeptAndTold) {
  const Equilibrium result = solve(bentGrid({14, 13, 3}, 5), {.iterationLimit = 3});
  EXPECT_FALSE(result.converged);
  EXPECT_EQ(result.reason, StopReason::iterationLimit);
  EXPECT_LE(result.iterations, 4);
}

}  // namespace
}  // namespace morphgrid
