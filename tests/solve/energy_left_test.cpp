#include "solve/energy_left.h"

#include <gtest/gtest.h>

#include "energy/strut_energy.h"
#include "solve/preconditioners.h"
#include "solve/reference_solver.h"
#include "tests/solve/sample_grids.h"

namespace morphgrid {
namespace {

double energyAt(const StrutGrid& grid, const Eigen::Matrix3Xd& positions) {
  return StrutEnergy(grid).evaluate(positions).energy;
}

TEST(EnergyLeft, IsWhatIsAboveTheMinimumNearby) {
  const StrutGrid grid = bentGrid({6, 5, 3}, 8);
  const Eigen::Matrix3Xd rest = solveReference(grid, {.tolerance = 1e-12}).positions;
  const Preconditioner preconditioner = constantMatrixPreconditioner(grid);
  const Eigen::Matrix3Xd away = shaken(rest, 1e-4, 3);
  const double above = energyAt(grid, away) - energyAt(grid, rest);
  EXPECT_NEAR(energyLeft(grid, away, preconditioner) / above, 1, 0.05);
}

TEST(EnergyLeft, CountsWhatIsSoft) {
  // Struts a millionth as stiff as posts: the residual hardly knows of them.
  StrutGrid grid = bentGrid({6, 5, 3}, 8);
  forEachLateralStrut(grid.shape,
                      [&](const Strut& strut) { valueAt(grid.stiffness, strut) = 4e-5; });
  grid.weights = TermWeights::ofAllCorners(1e-5);
  const Eigen::Matrix3Xd rest =
      solveReference(grid, {.tolerance = 1e-13, .iterationLimit = 20000}).positions;
  const Eigen::Matrix3Xd away = 1.001 * rest;
  const double above = energyAt(grid, away) - energyAt(grid, rest);
  EXPECT_NEAR(energyLeft(grid, away, constantMatrixPreconditioner(grid)) / above, 1, 0.1);
}

TEST(EnergyLeft, NothingIsLeftOfNothing) {
  const StrutGrid grid = bentGrid({3, 3, 2}, 8);
  StrutGrid relaxed = grid;
  forEachStrut(grid.shape, [&](const Strut& strut) {
    valueAt(relaxed.rest, strut) =
        (grid.positions.col(strut.to) - grid.positions.col(strut.from)).norm();
  });
  EXPECT_LT(energyLeft(relaxed, relaxed.positions, constantMatrixPreconditioner(relaxed)), 1e-20);
}

}  // namespace
}  // namespace morphgrid
