#include <gtest/gtest.h>

#include <cmath>

#include "inverse/lateral_rest.h"
#include "inverse/shape_error.h"
#include "solve/frame_solver.h"
#include "solve/multigrid_solver.h"
#include "tests/solve/frame_grids.h"
#include "tests/solve/sample_grids.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

class FrameInverseTest : public DeviceTest {
 protected:
  /// The whole chain of a frame: rest lengths, equilibrium, alignment, distance. The device's
  /// adjoint beside equilibria of Newton's method in double precision.
  void expectGradientOfDifferences(const StrutGrid& grid) const;
};

void FrameInverseTest::expectGradientOfDifferences(const StrutGrid& grid) const {
  const Equilibrium equilibrium = solveFrame(grid, {.tolerance = 1e-12});
  ASSERT_TRUE(equilibrium.converged);
  Matrix3Xd targets = middleLayer(grid.shape, equilibrium.positions);
  targets.row(2).array() += 0.05 * targets.row(0).array().square();

  MultigridSolver solver(device_, grid);
  solver.moveTo(equilibrium.positions, equilibrium.rotations);
  const ShapeError error = computeShapeError(grid.shape, equilibrium.positions, targets);
  const Adjoint adjoint = solver.solveAdjoint(error.gradient, {.tolerance = 1e-5});
  EXPECT_TRUE(adjoint.converged) << adjoint.residual << " after " << adjoint.products;
  EXPECT_EQ(adjoint.lambda.cols(), 2 * grid.shape.vertexCount());
  const LateralRest lateral(grid.shape);
  const VectorXd gradient = lateral.gradient(grid, equilibrium, adjoint.lambda);

  const auto objectiveWith = [&](const VectorXd& rest) {
    StrutGrid changed = grid;
    changed.rest = lateral.replacedIn(grid, rest);
    const Equilibrium moved = solveFrame(changed, {.tolerance = 1e-12});
    return computeShapeError(grid.shape, moved.positions, targets).objective;
  };
  const VectorXd rest = lateral.of(grid);
  constexpr double kStep = 1e-4;
  for (Eigen::Index n = 0; n < lateral.size(); n += 7) {
    const VectorXd step = kStep * VectorXd::Unit(lateral.size(), n);
    const double slope = (objectiveWith(rest + step) - objectiveWith(rest - step)) / (2 * kStep);
    EXPECT_NEAR(gradient[n], slope, 2e-3 * gradient.cwiseAbs().maxCoeff()) << n;
  }
}

TEST_F(FrameInverseTest, AdjointGradientIsThatOfFiniteDifferences) {
  expectGradientOfDifferences(
      welded(bentGrid({5, 4, 3}, 5), {.width = 0.2, .height = 0.15, .joint = 0.05}));
}

TEST_F(FrameInverseTest, OfAGridUnderWeightToo) {
  const StrutGrid grid =
      welded(bentGrid({5, 4, 3}, 5), {.width = 0.2, .height = 0.15, .joint = 0.05});
  expectGradientOfDifferences(weighedDown(grid, {0, 0, -1e-3}, {7}));
}

}  // namespace
}  // namespace morphgrid
