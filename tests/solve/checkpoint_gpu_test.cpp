// A solve can be left anywhere and gone on with in another process, to the same answer.
#include <gmock/gmock.h>

#include <map>

#include "core/error.h"
#include "gpu/command_stream.h"
#include "shared/solver_types.h"
#include "solve/jacobi_solver.h"
#include "solve/multigrid_solver.h"
#include "solve/reference_solver.h"
#include "tests/solve/reference_problem.h"
#include "tests/solve/sample_grids.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

using Solve = Equilibrium (*)(const Device&, const StrutGrid&, const SolveOptions&);

Equilibrium byMultigrid(const Device& device, const StrutGrid& grid, const SolveOptions& options) {
  DeviceGrid deviceGrid(device, grid);
  return solveMultigrid(device, grid, deviceGrid, options);
}

Equilibrium byJacobi(const Device& device, const StrutGrid& grid, const SolveOptions& options) {
  DeviceGrid deviceGrid(device, grid);
  return JacobiSolver(device, grid, deviceGrid).solve(options);
}

Equilibrium byReference(const Device&, const StrutGrid& grid, const SolveOptions& options) {
  return solveReference(grid, options);
}

struct Method {
  const char* name;
  Solve solve;
  std::vector<int> phases;  ///< To go on from.
};

class Checkpoints : public DeviceTest, public testing::WithParamInterface<Method> {
 protected:
  Equilibrium solve(const SolveOptions& options) {
    return GetParam().solve(device_, grid_, options);
  }
  /// The first checkpoint of each phase.
  std::map<int, SolveCheckpoint> checkpoints() {
    std::map<int, SolveCheckpoint> byPhase;
    solve({.onCheckpoint = [&](SolveCheckpoint checkpoint) {
      byPhase.emplace(checkpoint.phase, std::move(checkpoint));
    }});
    return byPhase;
  }

  const StrutGrid grid_ = bentGrid({14, 12, 2}, 5);
};

TEST_P(Checkpoints, LeadToTheSameAnswer) {
  const Equilibrium whole = solve({});
  ASSERT_TRUE(whole.converged);
  const std::map<int, SolveCheckpoint> byPhase = checkpoints();
  for (const int phase : GetParam().phases) {
    SCOPED_TRACE(phase);
    ASSERT_TRUE(byPhase.contains(phase));
    const SolveCheckpoint& checkpoint = byPhase.at(phase);
    const Equilibrium resumed = solve({.resumeFrom = checkpoint});
    EXPECT_TRUE(resumed.converged);
    EXPECT_NEAR(resumed.energy / whole.energy, 1, 1e-8);
    EXPECT_LT(largestAlignedDistance(resumed.positions, whole.positions), 1e-3 * grid_.spacing);
    EXPECT_GT(resumed.iterations, checkpoint.iterations);
    EXPECT_GT(resumed.seconds, checkpoint.seconds);
    ASSERT_GT(resumed.history.size(), checkpoint.history.size());
    EXPECT_EQ(resumed.history[0].energy, checkpoint.history[0].energy);
  }
}

TEST_P(Checkpoints, TheLimitIsOfAllIterations) {
  SolveCheckpoint last;
  const auto keep = [&](SolveCheckpoint checkpoint) { last = std::move(checkpoint); };
  EXPECT_FALSE(solve({.iterationLimit = 6, .onCheckpoint = keep}).converged);
  EXPECT_GT(last.iterations, 0);
  const Equilibrium resumed = solve({.iterationLimit = 6, .resumeFrom = last});
  EXPECT_EQ(resumed.reason, StopReason::iterationLimit);
  EXPECT_EQ(resumed.iterations, static_cast<long>(std::ceil(last.iterations)));
}

TEST_P(Checkpoints, OfOtherGridsAreRefused) {
  SolveCheckpoint other = checkpoints().begin()->second;
  other.positions.conservativeResize(3, other.positions.cols() - 1);
  EXPECT_THROW(solve({.resumeFrom = other}), InputError);
}

INSTANTIATE_TEST_SUITE_P(Methods, Checkpoints,
                         testing::Values(Method{"multigrid", byMultigrid, {0, 1}},
                                         Method{"jacobi", byJacobi, {1, 6, 10}},
                                         Method{"reference", byReference, {0}}),
                         [](const auto& test) { return std::string(test.param.name); });

class DevicePositions : public DeviceTest {};

TEST_F(DevicePositions, ComeBackBitForBit) {
  StrutGrid grid = bentGrid({14, 13, 3}, 5);
  grid.positions.colwise() += Eigen::Vector3d(1000, -300, 0.1);
  DeviceGrid deviceGrid(device_, grid);
  const Equilibrium result = solveMultigrid(device_, grid, deviceGrid, {});
  const int count = grid.shape.vertexCount();
  const auto before = download<ivec4>(device_, deviceGrid.positions(), count);
  deviceGrid.uploadPositions(deviceGrid.downloadPositions());
  EXPECT_EQ(download<ivec4>(device_, deviceGrid.positions(), count), before);
}

TEST_F(DevicePositions, OfANestedGridStandForThoseOfTheFinest) {
  const StrutGrid grid = bentGrid({14, 12, 2}, 5);
  std::map<int, SolveCheckpoint> first;
  const Equilibrium result = byMultigrid(device_, grid, {.onCheckpoint = [&](SolveCheckpoint c) {
                                           first.emplace(c.phase, std::move(c));
                                         }});
  first.erase(0);  // Which starts flat; later grids start where coarser ones came to rest.
  EXPECT_FALSE(first.empty());
  for (const auto& [phase, checkpoint] : first) {
    const Eigen::Matrix3Xd positions = finestPositions(grid, checkpoint);
    EXPECT_LT(largestAlignedDistance(positions, result.positions),
              0.3 * largestAlignedDistance(grid.positions, result.positions))
        << phase;
  }
}

}  // namespace
}  // namespace morphgrid
