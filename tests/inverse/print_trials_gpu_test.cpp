// What becomes of grids whose rest lengths are off, and which lengths matter.
#include "inverse/print_trials.h"

#include <gtest/gtest.h>

#include <cmath>

#include "solve/frame_solver.h"
#include "solve/reference_solver.h"
#include "tests/solve/frame_grids.h"
#include "tests/solve/sample_grids.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

class PrintTrialsTest : public DeviceTest {
 protected:
  /// Of grids that are solved anew, in double precision on the host.
  template <typename Solve>
  void expectSlopeOfResolvedGrids(const StrutGrid& grid, const Solve& solve) const;
};

template <typename Solve>
void PrintTrialsTest::expectSlopeOfResolvedGrids(const StrutGrid& grid, const Solve& solve) const {
  const Equilibrium equilibrium = solve(grid);
  Matrix3Xd goal = middleLayer(grid.shape, equilibrium.positions);
  goal.row(2).array() += 0.02 * goal.row(0).array().square();
  MultigridSolver solver(device_, grid);
  PrintTrials trials(solver, equilibrium, goal, {});
  const auto slope = trials.slope();
  ASSERT_TRUE(slope);
  const LateralRest lateral(grid.shape);
  const auto distanceWith = [&](const VectorXd& rest) {
    StrutGrid changed = grid;
    changed.rest = lateral.replacedIn(grid, rest);
    return computeShapeError(grid.shape, solve(changed).positions, goal).rmsPercent;
  };
  const VectorXd rest = lateral.of(grid);
  constexpr double kStep = 1e-4;
  for (Eigen::Index n = 0; n < lateral.size(); n += 7) {
    const VectorXd step = kStep * VectorXd::Unit(lateral.size(), n);
    const double difference = (distanceWith(rest + step) - distanceWith(rest - step)) / (2 * kStep);
    EXPECT_NEAR((*slope)[n], difference, 2e-3 * slope->cwiseAbs().maxCoeff()) << n;
  }
  // A trial on the device, which keeps positions in single precision.
  constexpr double kTrialStep = 0.02;
  Eigen::Index most = 0;
  slope->cwiseAbs().maxCoeff(&most);
  const auto tryWith = [&](double step) {
    return trials.tryWith(
        lateral.replacedIn(grid, rest + step * VectorXd::Unit(lateral.size(), most)));
  };
  const PrintTrial more = tryWith(kTrialStep);
  const double change = more.error.rmsPercent - tryWith(-kTrialStep).error.rmsPercent;
  EXPECT_NEAR(change, 2 * kTrialStep * (*slope)[most], 0.03 * std::abs(change));
  EXPECT_TRUE(more.isConverged);
  EXPECT_FALSE(more.isJump);
}

TEST_F(PrintTrialsTest, SlopeIsThatOfResolvedSprings) {
  expectSlopeOfResolvedGrids(bentGrid({6, 5, 3}, 5), [](const StrutGrid& grid) {
    return solveReference(grid, {.tolerance = 1e-12});
  });
}

TEST_F(PrintTrialsTest, SlopeIsThatOfResolvedFrames) {
  expectSlopeOfResolvedGrids(
      welded(bentGrid({5, 4, 3}, 5), {.width = 0.2, .height = 0.15, .joint = 0.05}),
      [](const StrutGrid& grid) { return solveFrame(grid, {.tolerance = 1e-12}); });
}

TEST_F(PrintTrialsTest, MovementsAreThoseOfResolvedGrids) {
  const StrutGrid grid = bentGrid({6, 5, 3}, 5);
  const Equilibrium equilibrium = solveReference(grid, {.tolerance = 1e-12});
  const Matrix3Xd goal = middleLayer(grid.shape, equilibrium.positions);
  MultigridSolver solver(device_, grid);
  PrintTrials trials(solver, equilibrium, goal, {});
  EXPECT_FALSE(trials.slope());  // The distance is zero.
  const LateralRest lateral(grid.shape);
  const Eigen::MatrixXd movements = trials.movements(400, 3);
  ASSERT_EQ(movements.rows(), 400);
  const VectorXd rest = lateral.of(grid);
  constexpr double kStep = 1e-3;
  const auto movementBy = [&](const VectorXd& change) {
    StrutGrid changed = grid;
    changed.rest = lateral.replacedIn(grid, rest + kStep * change);
    const Equilibrium moved = solveReference(changed, {.tolerance = 1e-12});
    return computeShapeError(grid.shape, moved.positions, goal).rmsPercent / kStep;
  };
  for (Eigen::Index n = 0; n < lateral.size(); n += 17) {
    const VectorXd change = VectorXd::Unit(lateral.size(), n);
    const double movement = movementBy(change);
    EXPECT_NEAR((movements * change).norm(), movement, 0.15 * movement) << n;
  }
  const VectorXd tier =
      VectorXd::Ones(lateral.size())
          .cwiseProduct(
              (VectorXd::LinSpaced(lateral.size(), 0, 1).array() < 0.34).cast<double>().matrix());
  const double movement = movementBy(tier);
  EXPECT_NEAR((movements * tier).norm(), movement, 0.15 * movement);
}

/// A sheet whose middle is too wide for its rim: it stands up or down.
class BistableSheet : public PrintTrialsTest {
 protected:
  BistableSheet() {
    forEachLateralStrut(grid_.shape, [&](const Strut& strut) {
      const Eigen::Vector3d place =
          (grid_.positions.col(strut.from) + grid_.positions.col(strut.to)) / 2;
      const double away = std::hypot(place.x() - 4, place.y() - 4) / 5;
      valueAt(grid_.rest, strut) = 1 + 0.15 * std::max(0.0, 1 - away * away);
    });
    near_.positions = grid_.positions;
    for (Eigen::Index n = 0; n < near_.positions.cols(); ++n) {
      const double away = (near_.positions.col(n).head<2>() - Eigen::Vector2d(4, 4)).norm();
      near_.positions(2, n) += 2 * std::cos(away / 4);
    }
  }

  /// The upper layer's lengths times a factor.
  StrutValues withUpper(double factor) const {
    StrutValues rest = grid_.rest;
    forEachLateralStrut(grid_.shape, [&](const Strut& strut) {
      if (strut.layer == 1) valueAt(rest, strut) *= factor;
    });
    return rest;
  }

  StrutGrid grid_ = bentGrid({9, 9, 2}, 5);
  Equilibrium near_;
};

TEST_F(BistableSheet, JumpsAreSeen) {
  const Matrix3Xd goal = middleLayer(grid_.shape, near_.positions);
  MultigridSolver solver(device_, grid_);
  PrintTrials trials(solver, near_, goal, {});
  EXPECT_FALSE(trials.tryWith(withUpper(1.02)).isJump);
  EXPECT_FALSE(trials.tryWith(withUpper(0.99)).isJump);
  const PrintTrial over = trials.tryWith(withUpper(0.75));
  EXPECT_TRUE(over.isJump);
  EXPECT_FALSE(trials.tryWith(withUpper(1.02)).isJump);  // Each begins where the first did.
}

}  // namespace
}  // namespace morphgrid
