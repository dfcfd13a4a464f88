#include <gtest/gtest.h>

#include <cmath>

#include "inverse/inverse_design.h"
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

/// Towards the equilibrium of other rest lengths.
class StepsOfAFrame : public DeviceTest {
 protected:
  struct Ends {
    InverseDesign design;
    double softnessBefore, softnessAfter;
  };

  Ends designWith(double softest) const {
    const StrutGrid grid =
        welded(bentGrid({5, 4, 3}, 5), {.width = 0.2, .height = 0.15, .joint = 0.05});
    const LateralRest lateral(grid.shape);
    StrutGrid other = grid;
    VectorXd rest = lateral.of(grid);
    for (Eigen::Index n = 0; n < rest.size(); ++n) {
      rest[n] *= 1 + 0.03 * std::sin(0.7 * static_cast<double>(n));
    }
    other.rest = lateral.replacedIn(other, rest);
    const Matrix3Xd targets =
        middleLayer(grid.shape, solveFrame(other, {.tolerance = 1e-11}).positions);

    MultigridSolver solver(device_, grid);
    const Equilibrium first = solver.solve({});
    InverseDesigner designer(solver, targets, {.optimiseSteps = 12, .softest = softest});
    Ends ends{designer.run(first), 0, 0};
    Softness softness(solver);
    ends.softnessBefore = softnessAt(solver, softness, grid.rest, first);
    ends.softnessAfter = softnessAt(solver, softness, ends.design.rest, ends.design.equilibrium);
    return ends;
  }

 private:
  static double softnessAt(MultigridSolver& solver, Softness& softness, const StrutValues& rest,
                           const Equilibrium& equilibrium) {
    solver.setRest(rest);
    solver.moveTo(equilibrium.positions, equilibrium.rotations);
    return softness.at(equilibrium);
  }
};

TEST_F(StepsOfAFrame, AreTakenWhileItStaysFirm) {
  const Ends ends = designWith(kSoftest);
  EXPECT_EQ(ends.design.refusedAsSoft, 0);
  EXPECT_LT(ends.design.steps.back().rmsPercent, 0.3 * ends.design.steps.front().rmsPercent);
}

TEST_F(StepsOfAFrame, AreRefusedWhereTheySoftenIt) {
  const Ends ends = designWith(100);  // So that any step that makes it softer is refused.
  EXPECT_GT(ends.design.refusedAsSoft, 0);
  EXPECT_GT(ends.softnessAfter, 0.98 * ends.softnessBefore);
}

}  // namespace
}  // namespace morphgrid
