#include <gtest/gtest.h>

#include <random>

#include "benchmark/avx2_sweep.h"
#include "solve/jacobi_solver.h"
#include "tests/solve/sample_grids.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;

enum class Stiffness { uniform, varied };

/// A grid far from equilibrium.
StrutGrid wildGrid(const GridShape& shape, Stiffness stiffness) {
  StrutGrid grid = bentGrid(shape, 5);
  grid.positions = shaken(grid.positions, 0.1, 6);
  if (stiffness == Stiffness::varied) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> factor(0.5, 2);
    forEachStrut(shape,
                 [&](const Strut& strut) { valueAt(grid.stiffness, strut) *= factor(random); });
  }
  return grid;
}

/// What one sweep is: every vertex takes the weighted mean of what its constraints want, 0.9 of the
/// way.
Matrix3Xd gradientStep(const StrutGrid& grid) {
  const StrutEnergy energy(grid);
  const Eigen::VectorXd step = 0.9 * (2 * energy.constraintWeights()).cwiseInverse();
  return grid.positions - energy.evaluate(grid.positions).gradient * step.asDiagonal();
}

double largestDifference(const Matrix3Xd& a, const Matrix3Xd& b) {
  return (a - b).cwiseAbs().maxCoeff();
}

class Sweep : public DeviceTest,
              public testing::WithParamInterface<std::tuple<GridShape, Stiffness>> {
 protected:
  Matrix3Xd sweep(int count, bool precise = false) {
    DeviceGrid deviceGrid(device_, grid_);
    JacobiSolver solver(device_, grid_, deviceGrid);
    solver.sweep(count, precise);
    return deviceGrid.downloadPositions();
  }

  Matrix3Xd sweepOfPeer(int count) {
    Avx2Sweep peer(grid_);
    peer.run(count);
    return peer.positions();
  }

  StrutGrid grid_ = std::apply(wildGrid, GetParam());
};

TEST_P(Sweep, OneIsAGradientStep) {
  const Matrix3Xd expected = gradientStep(grid_);
  EXPECT_LT(largestDifference(sweep(1), expected), 1e-6);
  if (device_.hasFloat64()) {
    EXPECT_LT(largestDifference(sweep(1, true), expected), 1e-7);
  }
}

TEST_P(Sweep, OneAgreesWithThePeer) {
  if (!Avx2Sweep::isSupported()) {
    GTEST_SKIP() << "no AVX2";
  }
  EXPECT_LT(largestDifference(sweep(1), sweepOfPeer(1)), 1e-4);
}

TEST_P(Sweep, ManyAgreeWithThePeer) {
  if (!Avx2Sweep::isSupported()) {
    GTEST_SKIP() << "no AVX2";
  }
  for (const int count : {7, 16}) {
    EXPECT_LT(largestDifference(sweep(count), sweepOfPeer(count)), 1e-4) << count << " sweeps";
  }
}

// Sizes that fill neither blocks nor workgroups, layers below and above those that are unrolled.
INSTANTIATE_TEST_SUITE_P(OddShapes, Sweep,
                         testing::Combine(testing::Values(GridShape{2, 2, 1}, GridShape{2, 2, 2},
                                                          GridShape{13, 7, 3}, GridShape{3, 129, 4},
                                                          GridShape{300, 5, 3}, GridShape{5, 4, 9},
                                                          GridShape{3, 4, 15}),
                                          testing::Values(Stiffness::uniform, Stiffness::varied)));

class SweepOfAnyShape : public DeviceTest, public testing::WithParamInterface<GridShape> {};

// The device's own sums over a sweep, against the host's figures for the answer.
TEST_P(SweepOfAnyShape, MeasuresEnergyAndResidual) {
  const StrutGrid grid = wildGrid(GetParam(), Stiffness::varied);
  DeviceGrid deviceGrid(device_, grid);
  JacobiSolver solver(device_, grid, deviceGrid);
  const Equilibrium result = solver.solve({.tolerance = 1e-7});
  ASSERT_GE(result.history.size(), 2U);
  const ConvergenceSample& measured = result.history[result.history.size() - 2];
  EXPECT_NEAR(measured.energy / result.energy, 1, 1e-4);
  EXPECT_LT(measured.residual, 2e-7);
  EXPECT_GT(measured.residual, 0.1 * result.residual);
}

INSTANTIATE_TEST_SUITE_P(OddShapes, SweepOfAnyShape,
                         testing::Values(GridShape{9, 5, 1}, GridShape{7, 6, 3},
                                         GridShape{5, 5, 6}));

}  // namespace
}  // namespace morphgrid
