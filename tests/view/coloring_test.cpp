#include "view/coloring.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <numbers>

#include "grid/bar_section.h"
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

/// The same grid as bars, one of which is bent by `angle` at its end.
struct FrameResult : Result {
  explicit FrameResult(double angle = 0.1) {
    StrutGrid grid = *shown.grid;
    grid.rest = StrutValues(grid.shape);
    forEachStrut(grid.shape, [&](const Strut& strut) { valueAt(grid.rest, strut) = 1; });
    const BarSection section = rectangularSection({.width = 0.2, .height = 0.1}, 1);
    grid.bars = Bars{section, section, grid.positions};
    JointRotations rotations = unturnedJoints(grid.shape.vertexCount());
    rotations.col(0) =
        Eigen::Quaterniond(Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitZ())).coeffs();
    shown.grid = std::make_shared<StrutGrid>(grid);
    shown.rotations = std::make_shared<JointRotations>(rotations);
  }
};

TEST(BarColors, AreSharesOfTheLargest) {
  const FrameResult result;
  const ColorShares rotation =
      computeColors(Coloring::jointRotation, result.shown, result.snapshot);
  EXPECT_DOUBLE_EQ(rotation.shares.u[0], 1);
  EXPECT_DOUBLE_EQ(rotation.shares.v[0], 1);
  EXPECT_DOUBLE_EQ(rotation.shares.w[0], 0);
  EXPECT_DOUBLE_EQ(rotation.shares.u[1], 0);
  EXPECT_EQ(rotation.legend.marks.back().text, "5.7\u00b0");
  const ColorShares strain = computeColors(Coloring::bendingStrain, result.shown, result.snapshot);
  EXPECT_DOUBLE_EQ(strain.shares.u[0], 1);
  EXPECT_DOUBLE_EQ(strain.shares.w[0], 0);
  // Bars that do not turn at their other end: 4 EI / L at this one, but for what they shear.
  EXPECT_LT(std::stod(strain.legend.marks.back().text), 100 * 0.1 * 4 * 0.1);
  EXPECT_GT(std::stod(strain.legend.marks.back().text), 100 * 0.1 * 3 * 0.1);
}

TEST(BarColors, OfAStraightFrameAreThoseOfNone) {
  const FrameResult result(0);
  const ColorShares colors = computeColors(Coloring::bendingStrain, result.shown, result.snapshot);
  EXPECT_THAT(colors.shares.u, Each(DoubleEq(0)));
}

TEST(BarColors, AreOfBarsAlone) {
  Result springs;
  FrameResult frame;
  for (const Coloring coloring : {Coloring::bendingStrain, Coloring::jointRotation}) {
    EXPECT_FALSE(canColor(coloring, springs.shown, springs.snapshot));
    EXPECT_TRUE(canColor(coloring, frame.shown, frame.snapshot));
  }
  frame.shown.rotations.reset();
  EXPECT_FALSE(canColor(Coloring::bendingStrain, frame.shown, frame.snapshot));
}

TEST(AngleErrorColors, AreThoseOfTheSheetsJoints) {
  Result result;
  result.snapshot.angleErrors =
      std::make_shared<Eigen::VectorXd>(Eigen::VectorXd::LinSpaced(6, 0, std::numbers::pi / 36));
  const ColorShares colors = computeColors(Coloring::angleError, result.shown, result.snapshot);
  for (int n = 0; n < 6; ++n) {
    EXPECT_DOUBLE_EQ(colors.columns[n], n / 5.0) << n;
  }
  EXPECT_DOUBLE_EQ(colors.shares.u[0], 0.1);
  EXPECT_EQ(colors.legend.marks.back().text, "5\u00b0");
}

TEST(AngleErrorColors, WithoutAConformalSheetSayWhyThereAreNone) {
  const Result result;
  EXPECT_THAT(whatIsMissing(Coloring::angleError, result.shown, result.snapshot),
              testing::HasSubstr("design.layout"));
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
