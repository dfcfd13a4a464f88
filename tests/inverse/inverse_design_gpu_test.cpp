#include "inverse/inverse_design.h"

#include <gtest/gtest.h>

#include <cmath>

#include "energy/exact_hessian.h"
#include "solve/reference_solver.h"
#include "tests/solve/sample_grids.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

/// A target that the grid does not reach by itself: its own middle layer, bent a bit further.
Matrix3Xd bentFurther(const GridShape& shape, const Matrix3Xd& positions) {
  Matrix3Xd target = middleLayer(shape, positions);
  const Eigen::Vector3d centre = target.rowwise().mean();
  target.row(2).array() += 0.02 * (target.row(0).array() - centre.x()).square();
  return target;
}

class InverseDesignTest : public DeviceTest {
 protected:
  Equilibrium solveFirst() { return solveReference(grid_, {.tolerance = 1e-11}); }

  StrutGrid grid_ = bentGrid({6, 5, 3}, 5);
};

// The whole chain: rest lengths, equilibrium, alignment, distance.
TEST_F(InverseDesignTest, AdjointGradientIsThatOfFiniteDifferences) {
  const Equilibrium equilibrium = solveFirst();
  const Matrix3Xd targets = bentFurther(grid_.shape, equilibrium.positions);
  const auto objectiveWith = [&](const LateralRest& lateral, const VectorXd& rest) {
    StrutGrid grid = grid_;
    grid.rest = lateral.replacedIn(grid, rest);
    grid.positions = equilibrium.positions;
    const Equilibrium moved = solveReference(grid, {.tolerance = 1e-13});
    return computeShapeError(grid.shape, moved.positions, targets).objective;
  };

  MultigridSolver solver(device_, grid_);
  solver.moveTo(equilibrium.positions);
  const ShapeError error = computeShapeError(grid_.shape, equilibrium.positions, targets);
  const Adjoint adjoint = solver.solveAdjoint(error.gradient, {.tolerance = 1e-5});
  EXPECT_TRUE(adjoint.converged) << adjoint.residual << " after " << adjoint.products;
  const LateralRest lateral(grid_.shape);
  const VectorXd gradient = lateral.gradient(grid_, equilibrium, adjoint.lambda);

  const VectorXd rest = lateral.of(grid_);
  constexpr double kStep = 1e-4;
  for (Eigen::Index n = 0; n < lateral.size(); n += 7) {
    VectorXd changed = rest;
    changed[n] += kStep;
    const double above = objectiveWith(lateral, changed);
    changed[n] -= 2 * kStep;
    const double below = objectiveWith(lateral, changed);
    EXPECT_NEAR(gradient[n], (above - below) / (2 * kStep), 1e-3 * gradient.cwiseAbs().maxCoeff())
        << "strut " << n;
  }
}

TEST_F(InverseDesignTest, AdjointSolvesTheExactSystem) {
  const Equilibrium equilibrium = solveFirst();
  const Matrix3Xd targets = bentFurther(grid_.shape, equilibrium.positions);
  const ShapeError error = computeShapeError(grid_.shape, equilibrium.positions, targets);
  MultigridSolver solver(device_, grid_);
  solver.moveTo(equilibrium.positions);
  const Adjoint adjoint = solver.solveAdjoint(error.gradient);
  EXPECT_TRUE(adjoint.converged);
  EXPECT_LE(adjoint.products, 60);
  const Matrix3Xd product = ExactHessian(grid_, equilibrium.positions).product(adjoint.lambda);
  EXPECT_LT((product - error.gradient).norm(), 3e-3 * error.gradient.norm());
}

TEST_F(InverseDesignTest, OptimisationMeetsAReachableTarget) {
  const Equilibrium first = solveFirst();
  StrutGrid other = grid_;
  const LateralRest lateral(grid_.shape);
  // Another design of the same grid, whose equilibrium is the target.
  VectorXd rest = lateral.of(grid_);
  for (Eigen::Index n = 0; n < rest.size(); ++n) {
    rest[n] *= 1 + 0.03 * std::sin(0.7 * static_cast<double>(n));
  }
  other.rest = lateral.replacedIn(other, rest);
  const Matrix3Xd targets =
      middleLayer(grid_.shape, solveReference(other, {.tolerance = 1e-11}).positions);

  MultigridSolver solver(device_, grid_);
  solver.moveTo(first.positions);
  InverseDesigner designer(solver, targets, {.optimiseSteps = 20});
  const InverseDesign result = designer.run(first);
  EXPECT_LT(result.steps.back().rmsPercent, 0.15 * result.steps.front().rmsPercent)
      << result.steps.size() << " steps, " << result.ending << ", "
      << toString(result.equilibrium.reason);
  for (std::size_t n = 1; n < result.steps.size(); ++n) {
    EXPECT_LT(result.steps[n].rmsPercent, result.steps[n - 1].rmsPercent);
  }
  EXPECT_TRUE(result.equilibrium.converged);
  ASSERT_TRUE(result.fromFlat);
  EXPECT_TRUE(result.fromFlat->sameEquilibrium);
  EXPECT_NEAR(result.fromFlat->rmsPercent, result.steps.back().rmsPercent,
              0.01 * result.steps.front().rmsPercent);
}

TEST_F(InverseDesignTest, TellsOfTheCheckFromFlatWhileItStandsAtItsDesign) {
  const Equilibrium first = solveFirst();
  const Matrix3Xd targets = bentFurther(grid_.shape, first.positions);
  MultigridSolver solver(device_, grid_);
  Matrix3Xd told;
  StrutValues toldRest;
  InverseDesigner designer(solver, targets, {.optimiseSteps = 1, .onCheckFromFlat = [&] {
                                               told = solver.onDevice()->downloadPositions();
                                               toldRest = solver.grid().rest;
                                             }});
  const InverseDesign result = designer.run(first);
  ASSERT_TRUE(result.fromFlat);
  EXPECT_LT((told - result.equilibrium.positions).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_EQ(toldRest.u, result.rest.u);
  EXPECT_EQ(toldRest.v, result.rest.v);
}

TEST_F(InverseDesignTest, ShrinkStaysWithinItsBound) {
  const Equilibrium first = solveFirst();
  const Matrix3Xd targets = bentFurther(grid_.shape, first.positions);
  const LateralRest lateral(grid_.shape);
  const VectorXd printed = lateral.lengthsAt(grid_.positions);
  constexpr double kLimit = 0.12;
  MultigridSolver solver(device_, grid_);
  InverseDesigner designer(
      solver, targets,
      {.compensateRounds = 2, .optimiseSteps = 6, .shrinkBounds = ShrinkBounds{{0, kLimit}}});
  const InverseDesign result = designer.run(first);
  const VectorXd rest = lateral.of(solver.grid());
  EXPECT_GE((rest - (1 - kLimit) * printed).minCoeff(), -1e-12);
  EXPECT_LE((rest - printed).maxCoeff(), 1e-12);
  EXPECT_LE(result.steps.back().largestShrinkPercent, 100 * kLimit + 1e-9);
}

}  // namespace
}  // namespace morphgrid
