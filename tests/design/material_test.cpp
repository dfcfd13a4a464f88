#include "design/material.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/design/stacked_grid.h"

namespace morphgrid {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

TEST(ApplyMaterial, LeavesThePapersGridAlone) {
  StrutGrid grid = stackedGridOfTwoLayers();
  applyMaterial(grid, {});
  EXPECT_EQ(mechanicsOf(grid), Mechanics::springs);
}

// EA = 2 w L = 12, EI = EA t^2 / 12 = 0.04; weights of frame.md: (w / 4) (t / L)^2, and that of
// posts.
TEST(ApplyMaterial, WeighsSpringsAsBars) {
  StrutGrid grid = stackedGridOfTwoLayers();
  applyMaterial(grid, {.model = Model::bars, .barWidth = 0.2});
  EXPECT_EQ(mechanicsOf(grid), Mechanics::springsAsPrinted);
  EXPECT_EQ(*grid.printedCorners, grid.positions);
  EXPECT_NEAR(grid.weights.angle, 3.0 / 4 * 0.1 * 0.1, 1e-12);
  EXPECT_NEAR(grid.weights.postAngle, 1.5 * 0.04 * (4 + 1) / ((2 + 1) * 4 * 1), 1e-12);
  EXPECT_NEAR(grid.stiffness.w[0], 3 * 2.0 / 1, 1e-12);
  EXPECT_EQ(grid.stiffness.u[0], 3);
  validate(grid);
}

// Twice as wide, they bend in their plane with 8 times EI at twice EA.
TEST(ApplyMaterial, WeighsCornersByTheirBarsBending) {
  StrutGrid grid = stackedGridOfTwoLayers();
  applyMaterial(grid, {.model = Model::bars, .barWidth = 0.4, .barHeight = 0.2, .postWidth = 0.2});
  EXPECT_NEAR(grid.weights.angle, 3.0 / 4 * 0.2 * 0.2, 1e-12);
  EXPECT_NEAR(grid.weights.postAngle, 1.5 * 0.04 * (4 + 1) / ((2 + 1.0 * 2) * 4 * 1), 1e-12);
}

TEST(ApplyMaterial, TakesBarsAFifthAsWideAsLong) {
  StrutGrid grid = stackedGridOfTwoLayers();
  applyMaterial(grid, {.model = Model::frame});
  const BarSection& bar = grid.bars->lateral;
  EXPECT_NEAR(bar.stretching, 2 * 3 * 2, 1e-12);
  EXPECT_NEAR(bar.bendingN, bar.stretching * 0.4 * 0.4 / 12, 1e-12);
  EXPECT_NEAR(bar.bendingB, bar.bendingN, 1e-12);
  EXPECT_NEAR(bar.joint, 0.1, 1e-15);
  EXPECT_EQ(bar.shearing, 0);
  EXPECT_NEAR(grid.bars->upright.stretching, bar.stretching, 1e-12);
  EXPECT_EQ(grid.bars->printed, grid.positions);
  validate(grid);
}

TEST(ApplyMaterial, TakesEachSizeAsAsked) {
  StrutGrid grid = stackedGridOfTwoLayers();
  applyMaterial(grid, {.model = Model::frame,
                       .barWidth = 0.2,
                       .barHeight = 0.4,
                       .postWidth = 0.1,
                       .jointRadius = 0.05});
  const BarSection& lateral = grid.bars->lateral;
  const BarSection& upright = grid.bars->upright;
  EXPECT_NEAR(lateral.bendingN / lateral.stretching, 0.2 * 0.2 / 12, 1e-12);
  EXPECT_NEAR(lateral.bendingB / lateral.stretching, 0.4 * 0.4 / 12, 1e-12);
  EXPECT_NEAR(upright.stretching / lateral.stretching, 0.1 * 0.1 / (0.2 * 0.4), 1e-12);
  EXPECT_EQ(lateral.joint, 0.05);
}

TEST(ApplyMaterial, RefusesJointsThatLeaveNothingOfAStrut) {
  StrutGrid grid = stackedGridOfTwoLayers();
  EXPECT_THAT([&] { applyMaterial(grid, {.model = Model::frame, .jointRadius = 50}); },
              testing::ThrowsMessage<InputError>(
                  HasSubstr("material.joint_radius must be less than half of the shortest strut")));
}

TEST(ApplyMaterial, RefusesJointsThatLeaveNothingOfAPost) {
  StrutGrid grid = stackedGridOfTwoLayers();
  const double spacing = grid.rest.w.front();
  const auto apply = [&](double height) {
    applyMaterial(grid,
                  {.model = Model::frame, .barHeight = height, .jointRadius = 0.501 * spacing});
  };
  apply(0.9 * spacing);
  EXPECT_THAT([&] { apply(2 * spacing); },
              testing::ThrowsMessage<InputError>(HasSubstr("leave nothing of a post")));
}

TEST(AdviseOnBars, TellsOfBarsThatOverlapAndOfStockyOnes) {
  StrutGrid grid = stackedGridOfTwoLayers();
  EXPECT_THAT(adviseOnBars(grid, {.model = Model::frame}), IsEmpty());
  EXPECT_THAT(adviseOnBars(grid, {.model = Model::frame, .barWidth = 0.8, .barHeight = 1.1}),
              ElementsAre(HasSubstr("lower material.bar_height or raise grid.layer_spacing"),
                          HasSubstr("lower material.bar_width or grid.nodes_long")));
  EXPECT_THAT(adviseOnBars(grid, {.barWidth = 5}), IsEmpty());
}

}  // namespace
}  // namespace morphgrid
