#include <gtest/gtest.h>

#include "energy/grid_energy.h"
#include "solve/frame_solver.h"
#include "solve/multigrid_solver.h"
#include "tests/solve/frame_grids.h"
#include "tests/solve/sample_grids.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
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

double largestDistance(const Matrix3Xd& points, const Matrix3Xd& others) {
  return (points - others).colwise().norm().maxCoeff();
}

class FramesUnderWeight : public DeviceTest {
 protected:
  /// By both solvers.
  std::vector<Equilibrium> solutionsOf(const StrutGrid& grid,
                                       const SolveOptions& options = tightly()) const {
    return {solveFrame(grid, options), MultigridSolver(device_, grid).solve(options)};
  }

  static StrutGrid bent(const Vector3d& weight) {
    const GridShape shape{9, 7, 3};
    return weighedDown(welded(bentGrid(shape, 3), kBars), weight, {shape.index(4, 3, 0)});
  }
};

/// Two beams side by side, joined by bars, held at one end: each sags by w L^4 / (8 EI). The weight
/// is that of the beams alone, and lumped on joints: by the trapezoidal rule, 1 / (3 n^2) more.
TEST_F(FramesUnderWeight, CantileverSagsByTheClosedForm) {
  constexpr int kBarCount = 10;
  constexpr double kWeight = 1e-7;  // Of a bar, over its EA.
  const GridShape shape{kBarCount + 1, 2, 1};
  StrutGrid grid = welded(unstrained(bentGrid(shape, 1)), {.width = 0.2, .height = 0.15});
  grid = weighedDown(std::move(grid), {0, 0, -kWeight}, {0, shape.index(0, 1, 0)});
  const BarSection& bar = grid.bars->lateral;
  grid.bars->loads->forces.row(2).array() += kWeight * bar.stretching / 2;
  const double expected = kWeight * bar.stretching * std::pow(kBarCount, 4) / (8 * bar.bendingB) *
                          (1 + 1 / (3.0 * kBarCount * kBarCount));
  SolveOptions options;
  options.tolerance = 1e-11;
  for (const Equilibrium& result : solutionsOf(grid, options)) {
    EXPECT_TRUE(result.converged) << toString(result.reason);
    EXPECT_LT(result.energy, 0);
    for (const int tip : {shape.index(kBarCount, 0, 0), shape.index(kBarCount, 1, 0)}) {
      EXPECT_NEAR(grid.positions(2, tip) - result.positions(2, tip), expected, 0.002 * expected);
    }
  }
}

/// Held in the middle, it hangs down alike on all sides.
TEST_F(FramesUnderWeight, ASymmetricGridSagsSymmetrically) {
  const GridShape shape{7, 7, 2};
  const StrutGrid grid = weighedDown(welded(unstrained(bentGrid(shape, 1)), kBars), {0, 0, -1e-5},
                                     {shape.index(3, 3, 0)});
  for (const Equilibrium& result : solutionsOf(grid)) {
    EXPECT_TRUE(result.converged) << toString(result.reason);
    const Eigen::VectorXd heights = result.positions.row(2) - grid.positions.row(2);
    EXPECT_LT(heights[0], -0.05);
    forEachVertex(shape, [&](const GridPlace& at) {
      const int mirrored = shape.index(6 - at.i, at.j, at.layer);
      const int swapped = shape.index(at.j, at.i, at.layer);
      EXPECT_NEAR(heights[shape.index(at)], heights[mirrored], 1e-4);
      EXPECT_NEAR(heights[shape.index(at)], heights[swapped], 1e-4);
    });
  }
}

TEST_F(FramesUnderWeight, BothSolversAgree) {
  const auto results = solutionsOf(bent({0, 0, -2e-4}));
  const Equilibrium& onHost = results[0];
  const Equilibrium& onDevice = results[1];
  EXPECT_TRUE(onHost.converged) << toString(onHost.reason);
  EXPECT_TRUE(onDevice.converged) << toString(onDevice.reason) << " " << onDevice.residual;
  EXPECT_LT(onDevice.iterations, 100);
  EXPECT_NEAR(onDevice.energy, onHost.energy, 3e-8 * std::abs(onHost.energy));
  // They are not aligned: what holds a joint says where the frame is.
  EXPECT_LT(largestDistance(onDevice.positions, onHost.positions), 1e-3);
}

}  // namespace
}  // namespace morphgrid
