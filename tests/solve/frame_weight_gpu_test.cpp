#include <gtest/gtest.h>

#include "solve/frame_solver.h"
#include "solve/multigrid_solver.h"
#include "tests/solve/frame_grids.h"
#include "tests/solve/frame_oracle.h"
#include "tests/solve/sample_grids.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

using Eigen::Vector3d;

constexpr BarSize kBars{.width = 0.2, .height = 0.15, .joint = 0.05, .isShearing = false};

StrutGrid unstrained(StrutGrid grid) {
  forEachStrut(grid.shape, [&](const Strut& strut) {
    valueAt(grid.rest, strut) = lengthAt(grid.positions, strut);
  });
  return grid;
}

SolveOptions tightly() {
  SolveOptions options;
  options.energyTolerance = 0;
  options.tolerance = 1e-7;
  return options;
}

class FramesUnderWeight : public DeviceTest {
 protected:
  /// By both solvers.
  std::vector<Equilibrium> solutionsOf(const StrutGrid& grid,
                                       const SolveOptions& options = tightly()) const {
    return {solveFrame(grid, options), MultigridSolver(device_, grid).solve(options)};
  }

  void expectSag(const StrutGrid& grid, int i, double expected) const;
};

/// Two beams side by side along u, joined by bars. They alone weigh, and on joints: end joints bear
/// half of what the others do.
StrutGrid twoBeams(int barCount, double weight, std::vector<int> held, bool slide) {
  StrutGrid grid =
      welded(unstrained(bentGrid({barCount + 1, 2, 1}, 1)), {.width = 0.2, .height = 0.15});
  grid = weighedDown(std::move(grid), {0, 0, -weight}, std::move(held), slide);
  const double ofBarsBetween = weight * grid.bars->lateral.stretching / 2;
  grid.bars->loads->forces.row(2).array() += ofBarsBetween;
  return grid;
}

constexpr int kBarCount = 10;
constexpr double kWeight = 1e-7;  // Of a bar, over its EA.

/// Of both beams at place i, once they have come to rest by either solver.
void FramesUnderWeight::expectSag(const StrutGrid& grid, int i, double expected) const {
  SolveOptions options;
  options.tolerance = 1e-11;
  for (const Equilibrium& result : solutionsOf(grid, options)) {
    EXPECT_TRUE(result.converged) << toString(result.reason);
    EXPECT_LT(result.energy, 0);
    for (const int joint : {grid.shape.index(i, 0, 0), grid.shape.index(i, 1, 0)}) {
      EXPECT_NEAR(grid.positions(2, joint) - result.positions(2, joint), expected,
                  0.002 * expected);
    }
  }
}

/// w L^4 / (8 EI), by the trapezoidal rule 1 / (3 n^2) more.
TEST_F(FramesUnderWeight, CantileverSagsByTheClosedForm) {
  const StrutGrid grid = twoBeams(kBarCount, kWeight, {0, kBarCount + 1}, false);
  const BarSection& bar = grid.bars->lateral;
  expectSag(grid, kBarCount,
            kWeight * bar.stretching * std::pow(kBarCount, 4) / (8 * bar.bendingB) *
                (1 + 1 / (3.0 * kBarCount * kBarCount)));
}

/// 5 w L^4 / (384 EI), by the trapezoidal rule 4 / (5 n^2) less.
TEST_F(FramesUnderWeight, ABeamOnTwoSupportsToo) {
  const StrutGrid grid =
      twoBeams(kBarCount, kWeight, {0, kBarCount, kBarCount + 1, 2 * kBarCount + 1}, true);
  const BarSection& bar = grid.bars->lateral;
  expectSag(grid, kBarCount / 2,
            5 * kWeight * bar.stretching * std::pow(kBarCount, 4) / (384 * bar.bendingB) *
                (1 - 4 / (5.0 * kBarCount * kBarCount)));
}

/// Held in the middle, it hangs down alike on all sides.
TEST_F(FramesUnderWeight, ASymmetricGridSagsSymmetrically) {
  const GridShape shape{7, 7, 2};
  const StrutGrid grid =
      weighedDown(welded(unstrained(bentGrid(shape, 1)), {.width = 0.2, .height = 0.2}),
                  {0, 0, -1e-5}, {shape.index(3, 3, 0)});
  for (const Equilibrium& result : solutionsOf(grid)) {
    EXPECT_TRUE(result.converged) << toString(result.reason);
    const Eigen::VectorXd heights = result.positions.row(2) - grid.positions.row(2);
    EXPECT_LT(heights[0], -0.03);
    forEachVertex(shape, [&](const GridPlace& at) {
      const int mirrored = shape.index(6 - at.i, at.j, at.layer);
      const int swapped = shape.index(at.j, at.i, at.layer);
      EXPECT_NEAR(heights[shape.index(at)], heights[mirrored], 3e-4);
      EXPECT_NEAR(heights[shape.index(at)], heights[swapped], 3e-4);
    });
  }
}

TEST_F(FramesUnderWeight, BothSolversAgree) {
  const GridShape shape{9, 7, 3};
  const StrutGrid frame = welded(bentGrid(shape, 3), kBars);
  const StrutGrid hanging = weighedDown(frame, {0, 0, -2e-4}, {shape.index(4, 3, 0)});
  const StrutGrid standing =
      weighedDown(frame, {0, 0, -2e-4},
                  {0, shape.index(8, 0, 0), shape.index(0, 6, 0), shape.index(8, 6, 0)}, true);
  for (const StrutGrid& grid : {hanging, standing}) {
    const auto results = solutionsOf(grid);
    const Equilibrium& onHost = results[0];
    const Equilibrium& onDevice = results[1];
    EXPECT_TRUE(onHost.converged) << toString(onHost.reason);
    EXPECT_TRUE(onDevice.converged) << toString(onDevice.reason) << " " << onDevice.residual;
    EXPECT_LT(onDevice.iterations, 150);
    EXPECT_NEAR(onDevice.energy, onHost.energy, 3e-8 * std::abs(onHost.energy));
    // Heights are not aligned: what holds a joint says where the frame is.
    EXPECT_LT((onDevice.positions - onHost.positions).row(2).cwiseAbs().maxCoeff(), 1e-3);
    EXPECT_LT(mismatchOf(onDevice.positions, onHost.positions).largest, 1e-2);
  }
}

}  // namespace
}  // namespace morphgrid
