#include "solve/solve_memory.h"

#include "core/error.h"
#include "solve/jacobi_solver.h"
#include "solve/multigrid_solver.h"
#include "solve/preconditioned_descent.h"
#include "solve/preconditioners.h"
#include "tests/solve/frame_grids.h"
#include "tests/solve/sample_grids.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

class SolveMemoryOf : public DeviceTest, public testing::WithParamInterface<GridShape> {
 protected:
  double peak() const { return static_cast<double>(device_.memoryUse().peak()); }
};

TEST_P(SolveMemoryOf, MultigridIsWhatItTakes) {
  const StrutGrid grid = bentGrid(GetParam(), 5);
  DeviceGrid deviceGrid(device_, grid);
  PreconditionedDescent descent(device_, deviceGrid, Precision::precise);
  descent.positions();
  EXPECT_NEAR(peak() / multigridMemory(grid.shape).device, 1, 0.15);
}

TEST_P(SolveMemoryOf, OfAFrameIsWhatItTakes) {
  const StrutGrid grid = welded(bentGrid(GetParam(), 5), {.width = 0.2, .height = 0.2});
  DeviceGrid deviceGrid(device_, grid);
  PreconditionedDescent descent(device_, deviceGrid, Precision::precise);
  descent.positions();
  EXPECT_NEAR(peak() / multigridMemory(grid.shape, Mechanics::frame).device, 1, 0.15);
}

TEST_P(SolveMemoryOf, InverseDesignOfAFrameToo) {
  const StrutGrid grid = welded(bentGrid(GetParam(), 5), {.width = 0.2, .height = 0.2});
  MultigridSolver solver(device_, grid);
  solver.solve({.iterationLimit = 1, .startsNear = true});
  solver.solveAdjoint(Eigen::Matrix3Xd::Random(3, grid.shape.vertexCount()), {.productLimit = 1});
  EXPECT_NEAR(peak() / inverseDesignMemory(grid.shape, Mechanics::frame).device, 1, 0.15);
}

TEST_P(SolveMemoryOf, InverseDesignIsWhatAdjointsTakeBesides) {
  const StrutGrid grid = bentGrid(GetParam(), 5);
  MultigridSolver solver(device_, grid);
  solver.solve({.iterationLimit = 1, .startsNear = true});
  solver.solveAdjoint(Eigen::Matrix3Xd::Random(3, grid.shape.vertexCount()), {.productLimit = 1});
  const double before = peak();
  EXPECT_NEAR(before / inverseDesignMemory(grid.shape).device, 1, 0.15);
  // And no more for other rest lengths, positions or right sides.
  solver.setRest(grid.rest);
  solver.moveTo(grid.positions);
  solver.solve({.iterationLimit = 1, .startsNear = true});
  solver.solveAdjoint(Eigen::Matrix3Xd::Random(3, grid.shape.vertexCount()), {.productLimit = 1});
  EXPECT_EQ(peak(), before);
}

TEST_P(SolveMemoryOf, JacobiIsWhatItTakes) {
  const StrutGrid grid = bentGrid(GetParam(), 5);
  DeviceGrid deviceGrid(device_, grid);
  const JacobiSolver solver(device_, grid, deviceGrid);
  vCyclePreconditioner(device_, deviceGrid)(grid.positions);
  EXPECT_NEAR(peak() / jacobiMemory(grid.shape).device, 1, 0.15);
}

TEST_P(SolveMemoryOf, WhatIsBoundIsTheLimit) {
  const StrutGrid grid = bentGrid(GetParam(), 5);
  const auto bytes = static_cast<std::uint32_t>(multigridMemory(grid.shape).mostBound);
  const Device enough({.largestStorageBuffer = bytes});
  DeviceGrid deviceGrid(enough, grid);
  EXPECT_NO_THROW(PreconditionedDescent(enough, deviceGrid, Precision::precise));
  const Device tooSmall({.largestStorageBuffer = bytes - 1});
  EXPECT_THROW(
      {
        DeviceGrid onSmall(tooSmall, grid);
        PreconditionedDescent(tooSmall, onSmall, Precision::precise);
      },
      DeviceError);
}

// The last one has rows too long to be split.
INSTANTIATE_TEST_SUITE_P(Shapes, SolveMemoryOf,
                         testing::Values(GridShape{90, 81, 1}, GridShape{75, 61, 3},
                                         GridShape{50, 51, 5}, GridShape{700, 14, 1}));

}  // namespace
}  // namespace morphgrid
