#include "solve/grid_gradient.h"

#include <gtest/gtest.h>

#include <random>

#include "energy/strut_energy.h"
#include "tests/solve/sample_grids.h"
#include "tests/solve/vertex_vectors.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;

class GridGradientTest
    : public DeviceTest,
      public testing::WithParamInterface<std::tuple<GridShape, Precision, LayerLoop>> {
 protected:
  struct Result {
    GridGradient::Sums sums;
    Matrix3Xd gradient;
  };

  void SetUp() override {
    if (precision_ == Precision::precise && !device_.hasFloat64()) {
      GTEST_SKIP() << "no float64";
    }
  }

  /// In units of the spacing.
  Result evaluate(const StrutGrid& grid) const {
    const DeviceGrid deviceGrid(device_, grid);
    GridGradient gradient(device_, deviceGrid, precision_, std::get<LayerLoop>(GetParam()));
    const VertexVector result(device_, grid.shape.vertexCount());
    const auto evaluation = gradient.evaluation(deviceGrid.positions(), result);
    CommandStream stream(device_);
    stream.begin();
    gradient.record(stream, evaluation);
    stream.end();
    stream.submitAndWait();
    const auto packed = download<vec4>(device_, result.buffer(), grid.shape.vertexCount());
    const Eigen::VectorXd values = unpackVector(packed);
    return {gradient.sums(), Matrix3Xd::Map(values.data(), 3, grid.shape.vertexCount())};
  }

  Precision precision_ = std::get<Precision>(GetParam());
};

StrutGrid wildGrid(const GridShape& shape) {
  StrutGrid grid = bentGrid(shape, 5);
  grid.spacing = 1.25;
  grid.positions = shaken(grid.positions, 0.1, 6);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> factor(0.5, 2);
  forEachStrut(shape,
               [&](const Strut& strut) { valueAt(grid.stiffness, strut) *= factor(random); });
  return grid;
}

TEST_P(GridGradientTest, AgreesWithTheHost) {
  const StrutGrid wild = wildGrid(std::get<GridShape>(GetParam()));
  for (const StrutGrid& grid : {wild, withPrintedCorners(wild)}) {
    const StrutEnergy::Value expected = StrutEnergy(grid).evaluate(grid.positions);
    const Matrix3Xd gradient = expected.gradient / grid.spacing;
    const Result result = evaluate(grid);
    EXPECT_LT((result.gradient - gradient).cwiseAbs().maxCoeff(),
              2e-6 * gradient.cwiseAbs().maxCoeff());
    EXPECT_NEAR(result.sums.energy * grid.spacing * grid.spacing / expected.energy, 1, 1e-6);
    EXPECT_NEAR(result.sums.squaredNorm / gradient.squaredNorm(), 1, 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(OddShapes, GridGradientTest,
                         testing::Combine(testing::Values(GridShape{2, 2, 1}, GridShape{13, 7, 3},
                                                          GridShape{3, 129, 4},
                                                          GridShape{300, 5, 3}, GridShape{5, 4, 9}),
                                          testing::Values(Precision::single, Precision::precise),
                                          testing::Values(LayerLoop::unrolled)));

INSTANTIATE_TEST_SUITE_P(Rolled, GridGradientTest,
                         testing::Combine(testing::Values(GridShape{2, 2, 1}, GridShape{13, 7, 3}),
                                          testing::Values(Precision::single, Precision::precise),
                                          testing::Values(LayerLoop::rolled)));

class PreciseGradient : public GridGradientTest {};

// A line search compares energies: their differences must be right where they are small.
TEST_P(PreciseGradient, EnergyResolvesSmallSteps) {
  StrutGrid grid = wildGrid(std::get<GridShape>(GetParam()));
  const StrutEnergy energy(grid);
  const StrutEnergy::Value start = energy.evaluate(grid.positions);
  const double deviceStart = evaluate(grid).sums.energy;
  const double unit = grid.spacing * grid.spacing;
  for (const double decrease : {1e-5, 1e-7}) {  // of the energy, to first order
    StrutGrid moved = grid;
    moved.positions -= decrease * start.energy / start.gradient.squaredNorm() * start.gradient;
    const double expected = energy.evaluate(moved.positions).energy - start.energy;
    const double difference = (evaluate(moved).sums.energy - deviceStart) * unit;
    EXPECT_NEAR(difference, expected, 1e-9 * start.energy) << decrease;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Sizes, PreciseGradient,
    testing::Combine(testing::Values(GridShape{21, 18, 3}, GridShape{50, 61, 3}),
                     testing::Values(Precision::precise), testing::Values(LayerLoop::unrolled)));

}  // namespace
}  // namespace morphgrid
