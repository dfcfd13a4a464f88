#include "solve/nested_grids.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/solve/frame_grids.h"
#include "tests/solve/sample_grids.h"

namespace morphgrid {
namespace {

constexpr GridShape kShape{42, 31, 3};

double sumAlongU(const StrutGrid& grid, int j, int k) {
  double sum = 0;
  for (int i = 0; i + 1 < grid.shape.verticesU; ++i) {
    sum += grid.rest.u[grid.shape.index(i, j, k)];
  }
  return sum;
}

TEST(NestedGrids, HalveDownToTenNodes) {
  const auto grids = nestGrids(circularStrip(41, 3, 0, 0.3));
  ASSERT_EQ(grids.size(), 4u);
  EXPECT_EQ(grids[0].grid.shape.verticesU, 7);
  EXPECT_EQ(grids[1].grid.shape.verticesU, 12);
  EXPECT_EQ(grids[2].grid.shape.verticesU, 22);
  EXPECT_EQ(grids[3].grid.shape.verticesU, 42);
  EXPECT_EQ(grids[3].thickness, 1);
  EXPECT_NEAR(grids[2].thickness, std::sqrt(2), 1e-12);
  EXPECT_NEAR(grids[0].thickness, 4 * std::sqrt(2), 1e-12);
}

TEST(NestedGrids, AreProblemsThatCanBeSolved) {
  for (const NestedGrid& nested : nestGrids(bentGrid(kShape, 3))) {
    EXPECT_NO_THROW(validate(nested.grid));
  }
}

TEST(NestedGrids, KeepTheLengthOfALine) {
  const StrutGrid fine = bentGrid(kShape, 3);
  const auto grids = nestGrids(fine);
  // The mean of the layers: what they differ by grows with the thickness.
  const auto mean = [](const StrutGrid& grid) {
    return (sumAlongU(grid, 0, 0) + sumAlongU(grid, 0, 1) + sumAlongU(grid, 0, 2)) / 3;
  };
  for (const NestedGrid& nested : grids) {
    EXPECT_NEAR(mean(nested.grid), mean(fine), 1e-9);
  }
}

TEST(NestedGrids, KeepTheCurvature) {
  constexpr double kTheta = 0.02;
  const auto grids = nestGrids(circularStrip(40, 3, kTheta, 0.3));
  ASSERT_GT(grids.size(), 2u);
  for (const NestedGrid& nested : grids) {
    const StrutGrid& grid = nested.grid;
    const double bottom = grid.rest.u[grid.shape.index(1, 0, 0)];
    const double top = grid.rest.u[grid.shape.index(1, 0, 2)];
    const double turn = (bottom - top) / (2 * grid.rest.w[grid.shape.index(1, 0, 0)]);
    const double nodes = 40.0 / (grid.shape.verticesU - 1);
    EXPECT_NEAR(turn / nodes, 2 * std::sin(kTheta / 2), 1e-9);
  }
}

TEST(NestedGrids, StopWhereStrutsWouldTurnTooFar) {
  EXPECT_EQ(nestGrids(circularStrip(40, 3, 0.6, 0.3)).size(), 1u);
}

TEST(NestedGrids, BeginWithHeavierCornersWhereTheyAreLight) {
  StrutGrid grid = bentGrid({18, 9, 2}, 3);  // Lateral stiffness 5.
  grid.weights = TermWeights::ofAllCorners(0.01);
  const auto grids = nestGrids(grid);
  ASSERT_EQ(grids.size(), 4u);
  EXPECT_DOUBLE_EQ(grids[0].grid.weights.angle, 1);
  EXPECT_DOUBLE_EQ(grids[1].grid.weights.angle, 0.1);
  EXPECT_EQ(grids[1].grid.shape, grids[2].grid.shape);
  EXPECT_EQ(grids[2].grid.weights.angle, 0.01);
  EXPECT_EQ(grids[3].grid.shape, grid.shape);
}

TEST(NestedGrids, CornersMayWeighNothing) {
  StrutGrid grid = bentGrid({5, 5, 2}, 3);
  grid.weights = TermWeights::ofAllCorners(0);
  const auto grids = nestGrids(grid);
  EXPECT_GT(grids.front().grid.weights.angle, 0.1);
  EXPECT_EQ(grids.back().grid.weights.angle, 0);
}

TEST(NestedGrids, CarryTheWeightAndHoldTheNearestJoint) {
  const StrutGrid fine = weighedDown(welded(bentGrid(kShape, 3), {.width = 0.2, .height = 0.2}),
                                     {1e-4, 0, -2e-4}, {kShape.index(20, 15, 0)});
  const Eigen::Vector3d weight = fine.bars->loads->forces.rowwise().sum();
  const auto grids = nestGrids(fine);
  ASSERT_GT(grids.size(), 2u);
  for (const NestedGrid& nested : grids) {
    EXPECT_NO_THROW(validate(nested.grid));
    const JointLoads& loads = *nested.grid.bars->loads;
    const Eigen::Vector3d expected = nested.thickness * nested.thickness * weight;
    EXPECT_LT((loads.forces.rowwise().sum() - expected).norm(), 1e-9 * expected.norm());
    ASSERT_EQ(loads.held.size(), 1u);
    const GridPlace held = nested.grid.shape.place(loads.held.front());
    EXPECT_NEAR(double(held.i) / nested.grid.shape.cellsU(), 20.0 / 41, 0.1);
    EXPECT_NEAR(double(held.j) / nested.grid.shape.cellsV(), 15.0 / 30, 0.1);
    EXPECT_EQ(held.layer, 0);
  }
  const NestedGrid& coarse = grids[grids.size() - 2];
  const Eigen::Matrix3Xd start = prolong(coarse, coarse.grid.positions, grids.back());
  const int joint = fine.bars->loads->held.front();
  EXPECT_LT((start.col(joint) - fine.bars->printed.col(joint)).norm(), 1e-9);
}

TEST(NestedGrids, ProlongedGridsStandOnTheirSupports) {
  const std::vector<int> corners{0, kShape.index(41, 0, 0), kShape.index(0, 30, 0),
                                 kShape.index(41, 30, 0)};
  const auto grids = nestGrids(weighedDown(
      welded(bentGrid(kShape, 3), {.width = 0.2, .height = 0.2}), {0, 0, -2e-4}, corners, true));
  const NestedGrid& coarse = grids[grids.size() - 2];
  const Bars& bars = *grids.back().grid.bars;
  Eigen::Matrix3Xd bent = coarse.grid.positions;
  bent.row(2).array() += 0.02 * bent.row(0).array() * bent.row(1).array();
  const Eigen::Matrix3Xd start = prolong(coarse, bent, grids.back());
  for (const int joint : corners) {
    EXPECT_NEAR(start(2, joint), bars.printed(2, joint), 1e-9);
  }
  // Aside nothing holds them.
  NestedGrid free = grids.back();
  free.grid.bars->loads.reset();
  EXPECT_LT((start - prolong(coarse, bent, free)).topRows<2>().norm(), 1e-12);
}

TEST(NestedGrids, ProlongationReproducesCubicsAndOffsets) {
  const auto grids = nestGrids(circularStrip(80, 3, 0, 0.3));
  const NestedGrid& coarse = grids[grids.size() - 2];
  const NestedGrid& fine = grids.back();
  const auto bent = [](const NestedGrid& nested) {
    const GridShape& shape = nested.grid.shape;
    Eigen::Matrix3Xd positions(3, shape.vertexCount());
    for (int k = 0; k < shape.layers; ++k) {
      for (int j = 0; j < shape.verticesV; ++j) {
        for (int i = 0; i < shape.verticesU; ++i) {
          const double u = double(i) / (shape.verticesU - 1);
          const double v = double(j) / (shape.verticesV - 1);
          positions.col(shape.index(i, j, k)) << u, v, u * u * u - 2 * u * u + u * v;
          positions.col(shape.index(i, j, k)) +=
              nested.thickness * (k - 1) * Eigen::Vector3d(u, 0, 1);
        }
      }
    }
    return positions;
  };
  EXPECT_LT((prolong(coarse, bent(coarse), fine) - bent(fine)).cwiseAbs().maxCoeff(), 1e-12);
}

}  // namespace
}  // namespace morphgrid
