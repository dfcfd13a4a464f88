#include "view/coloring.h"

#include <gmock/gmock.h>

#include "view/view_state.h"

namespace morphgrid {
namespace {

using testing::DoubleEq;
using testing::Each;

/// Two layers in the plane, half a unit above and below it.
StrutGrid twoLayers() {
  StrutGrid grid;
  grid.shape = {3, 2, 2};
  grid.positions.resize(3, grid.shape.vertexCount());
  for (int k = 0; k < 2; ++k) {
    for (int j = 0; j < 2; ++j) {
      for (int i = 0; i < 3; ++i) {
        grid.positions.col(grid.shape.index(i, j, k)) = Eigen::Vector3d(i, j, k - 0.5);
      }
    }
  }
  return grid;
}

/// A result that was moved by `worldFromGrid` to a target which lies under its columns, column n at
/// a distance of n.
struct Result {
  explicit Result(const Eigen::Isometry3d& worldFromGrid = Eigen::Isometry3d::Identity()) {
    const StrutGrid grid = twoLayers();
    shown.grid = std::make_shared<StrutGrid>(grid);
    shown.positions = std::make_shared<Eigen::Matrix3Xd>(grid.positions);
    shown.worldFromGrid = worldFromGrid;
    Eigen::Matrix3Xd targets = middleLayer(grid.shape, grid.positions);
    targets.row(2) -= Eigen::RowVectorXd::LinSpaced(targets.cols(), 0, targets.cols() - 1.0);
    snapshot.targets = std::make_shared<Eigen::Matrix3Xd>(worldFromGrid * targets);
    snapshot.stages[static_cast<std::size_t>(ShownStage::surface)] = shown;
    snapshot.newest = ShownStage::surface;
  }

  ShownGrid shown;
  Snapshot snapshot;
};

TEST(DistanceColors, OfColumnsAreTheirDistancesOverTheLargest) {
  const Result result;
  const ColorShares colors = computeColors(Coloring::distance, result.shown, result.snapshot);
  ASSERT_EQ(colors.columns.size(), 6);
  for (int n = 0; n < 6; ++n) {
    EXPECT_DOUBLE_EQ(colors.columns[n], n / 5.0) << n;
  }
}

TEST(DistanceColors, OfStrutsAreTheMeansOfTheirEnds) {
  const Result result;
  const ColorShares colors = computeColors(Coloring::distance, result.shown, result.snapshot);
  forEachStrut(result.shown.grid->shape, [&](const Strut& strut) {
    EXPECT_NEAR(valueAt(colors.shares, strut), (strut.from % 6 + strut.to % 6) / 10.0, 1e-15);
  });
}

TEST(DistanceColors, AreMeasuredWhereTheResultLiesInTheWorld) {
  Eigen::Isometry3d motion(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  motion.pretranslate(Eigen::Vector3d(30, -20, 10));
  const Result plain, moved(motion);
  const auto columnsOf = [](const Result& result) {
    return computeColors(Coloring::distance, result.shown, result.snapshot).columns;
  };
  EXPECT_TRUE(columnsOf(moved).isApprox(columnsOf(plain), 1e-12));
}

TEST(DistanceColors, LegendTellsTheLargestInTheScenesUnitAndOfTheDiagonal) {
  const Result result;
  const ColorShares colors = computeColors(Coloring::distance, result.shown, result.snapshot);
  const LegendMark& last = colors.legend.marks.back();
  EXPECT_EQ(last.secondLine, "5");
  EXPECT_EQ(last.text, "91 %");  // Percent of the diagonal of 2 x 1 x 5.
}

TEST(DistanceColors, OfAPerfectResultAreThoseOfNoDistance) {
  Result result;
  result.snapshot.targets = std::make_shared<Eigen::Matrix3Xd>(
      middleLayer(result.shown.grid->shape, *result.shown.positions));
  const ColorShares colors = computeColors(Coloring::distance, result.shown, result.snapshot);
  EXPECT_EQ(colors.columns, Eigen::VectorXd::Zero(6));
  EXPECT_THAT(colors.shares.u, Each(DoubleEq(0)));
}

TEST(Colors, BySomethingElseThanDistanceHaveNoneForSurfaces) {
  const Result result;
  EXPECT_EQ(computeColors(Coloring::layer, result.shown, result.snapshot).columns.size(), 0);
}

TEST(IsColored, TheResultsSurfaceByDistanceAlone) {
  const Result result;
  ViewState state;
  for (std::size_t n = 0; n < kColoringNames.size(); ++n) {
    state.coloring = static_cast<Coloring>(n);
    EXPECT_EQ(isColored(state, result.snapshot), state.coloring == Coloring::distance);
  }
}

TEST(IsColored, NoSurfaceWithoutATarget) {
  Result result;
  result.snapshot.targets.reset();
  ViewState state;
  state.coloring = Coloring::distance;
  EXPECT_FALSE(isColored(state, result.snapshot));
}

TEST(IsColored, StrutsAlwaysAndTheTargetNever) {
  Result result;
  for (const ShownStage stage : {ShownStage::target, ShownStage::warped}) {
    result.snapshot.stages[static_cast<std::size_t>(stage)] = result.shown;
  }
  ViewState state;
  state.coloring = Coloring::distance;
  state.stage = ShownStage::warped;
  EXPECT_TRUE(isColored(state, result.snapshot));
  state.stage = ShownStage::target;
  EXPECT_FALSE(isColored(state, result.snapshot));
}

}  // namespace
}  // namespace morphgrid
