#include "report/shrink_figures.h"

#include <gmock/gmock.h>

#include "design/build_grids.h"

namespace morphgrid {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

/// 3 x 2 cells, 3 layers 0.2 apart; the first u strut of each row bends by `theta` towards the top.
StrutGrid bentGrid(double theta) {
  const GridDesign design = designFromBendAngles({3, 2, 1, theta, 0, 0, 0}, 3, 0.2);
  const Eigen::Matrix3Xd printed = inPlaneGrid(design, {}, Scaling::normalised).positions;
  return stackedGrid(design, {}, Scaling::normalised, printed);
}

TEST(Shrink, IsAgainstThePrintedLength) {
  const double largest = 2 * 0.4 * std::sin(0.25);  // Eq. 25, on top
  const StrutGrid grid = bentGrid(0.5);
  EXPECT_NEAR(computeShrink(grid, {0, 0.1}).largestPercent, 100 * largest, 1e-12);
  EXPECT_EQ(computeShrink(grid, {0, largest - 1e-5}).strutsOverLimit, 3);  // one u strut a row
  EXPECT_EQ(computeShrink(grid, {0, largest + 1e-5}).strutsOverLimit, 0);
}

TEST(Shrink, BindsWhereItIsTheLimit) {
  const double largest = 2 * 0.4 * std::sin(0.25);
  const ShrinkFigures figures = computeShrink(bentGrid(0.5), {0, largest});
  EXPECT_EQ(figures.strutsOverLimit, 0);
  EXPECT_EQ(figures.strutsAtLimit, 3);
  EXPECT_EQ(figures.layers[1].strutsAtLimit, 0);
  EXPECT_EQ(figures.layers[2].strutsAtLimit, 3);
  EXPECT_EQ(computeShrink(bentGrid(0.5), {0, largest - 1e-5}).strutsAtLimit, 0);
}

TEST(Shrink, IsListedByLayer) {
  const ShrinkFigures figures = computeShrink(bentGrid(0.5), {0, 0.01});
  const auto percentOf = [](int layer) { return 100 * 2 * 0.2 * layer * std::sin(0.25); };
  ASSERT_EQ(figures.layers.size(), 3u);
  for (int layer = 0; layer < 3; ++layer) {
    EXPECT_NEAR(figures.layers[layer].largestPercent, percentOf(layer), 1e-12);
    EXPECT_EQ(figures.layers[layer].strutsGrowing, 0);
  }
  // theta falls linearly: 0.5, 0.25, 0 over the u struts of a row.
  EXPECT_EQ(figures.layers[0].strutsOverLimit, 0);
  EXPECT_EQ(figures.layers[1].strutsOverLimit, 6);
  EXPECT_EQ(figures.strutsOverLimit, 12);
  EXPECT_TRUE(adviseOn(computeShrink(bentGrid(0.5), {0, 0.4}), ShrinkRange{0, 0.4}).empty());
}

TEST(Shrink, GrowthIsTold) {
  StrutGrid grid = bentGrid(0.5);
  grid.rest.v[grid.shape.index(1, 1, 1)] = 1.25;
  const ShrinkFigures figures = computeShrink(grid, {0, 0.1});
  EXPECT_EQ(figures.strutsGrowing, 1);
  EXPECT_EQ(figures.layers[1].strutsGrowing, 1);
  EXPECT_NEAR(figures.largestGrowthPercent, 25, 1e-12);
  // A sheet printed 25 % larger: 1 - (1 - 0.1979) / 1.25.
  EXPECT_THAT(adviseOn(figures, ShrinkRange{0, 0.1}),
              ElementsAre(HasSubstr("3 of the struts must shrink by more than grid.max_shrinkage = "
                                    "10 %, by up to 19.8 %"),
                          HasSubstr("1 of the struts must grow, by up to 25.0 %")));
  EXPECT_THAT(adviseOn(figures, ShrinkRange{0, 0.1})[1],
              HasSubstr("the largest shrink is then 35.8 %"));
}

TEST(Shrink, VerticalStrutsDoNotCount) {
  StrutGrid grid = bentGrid(0);
  grid.rest.w.assign(grid.rest.w.size(), 0.01);
  EXPECT_NEAR(computeShrink(grid, {0, 0.1}).largestPercent, 0, 1e-12);
}

TEST(Shrink, StaysWhenTheSceneIsScaled) {
  StrutGrid grid = bentGrid(0.3);
  const double before = computeShrink(grid, {0, 0.1}).largestPercent;
  grid.positions *= 1e3;
  for (auto* rest : {&grid.rest.u, &grid.rest.v, &grid.rest.w}) {
    for (double& length : *rest) length *= 1e3;
  }
  EXPECT_NEAR(computeShrink(grid, {0, 0.1}).largestPercent, before, 1e-10);
}

TEST(Shrink, CountsWhatShrinksByLessThanTheMaterial) {
  const StrutGrid grid = bentGrid(0.5);
  int under = 0;
  const StrutValues shrinks = computeShrinks(grid);
  forEachLateralStrut(grid.shape, [&](const Strut& strut) {
    under += valueAt(shrinks, strut) < 0.01 - 1e-6 ? 1 : 0;
  });
  ASSERT_GT(under, 0);
  const ShrinkRange range{0.01, 0.9};
  const ShrinkFigures figures = computeShrink(grid, {range});
  EXPECT_EQ(figures.strutsUnderLeast, under);
  EXPECT_EQ(figures.strutsGrowing, 0);
  EXPECT_THAT(adviseOn(figures, range),
              testing::ElementsAre(HasSubstr("material.least_shrinkage = 1 %")));
  EXPECT_EQ(computeShrink(grid, {-0.01, 0.9}).strutsUnderLeast, 0);
}

TEST(Strain, IsThatOfTheLateralStruts) {
  StrutGrid grid = bentGrid(0);
  grid.rest.u[0] *= 1.0 / 1.05;
  const StrainFigures strain = computeStrain(grid, grid.positions, 0.03);
  EXPECT_NEAR(strain.largestPercent, 5, 1e-9);
  EXPECT_NEAR(strain.meanPercent, 5.0 / grid.shape.lateralStrutCount(), 1e-9);
  EXPECT_EQ(strain.strutsOverLimit, 1);
  EXPECT_THAT(adviseOn(strain, 0.03), testing::ElementsAre(HasSubstr("design.max_strain = 3 %")));
  EXPECT_TRUE(adviseOn(computeStrain(grid, grid.positions, 0.06), 0.06).empty());
  EXPECT_EQ(computeStrain(grid, grid.positions, {}).strutsOverLimit, 0);
}

}  // namespace
}  // namespace morphgrid
