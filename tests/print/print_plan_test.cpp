#include "print/print_plan.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/print/print_samples.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;

PrintPlan plan(const StrutGrid& grid, const PrintRequest& request = {}) {
  return planPrint("sample", grid, samplePrinter(), sampleMaterial(), request);
}

std::string refusal(const StrutGrid& grid, const PrintRequest& request = {},
                    const Printer& printer = samplePrinter(),
                    const PrintMaterial& material = sampleMaterial()) {
  try {
    planPrint("sample", grid, printer, material, request);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(HubShape, HasTheDiametersOfTheSpecification) {
  EXPECT_NEAR(hubShapeOf({}, {0.45, 0.2}).diameter, 3.66, 0.005);
  EXPECT_NEAR(hubShapeOf({.pin = 1.0, .loops = 1}, {0.45, 0.2}).diameter, 2.10, 1e-12);
  EXPECT_NEAR(hubShapeOf({}, {0.45, 0.2}).hole, 1.95, 1e-12);
}

TEST(PrintPlan, TheLargestScaleThatFitsIsTaken) {
  const PrintPlan flat = plan(flatGrid({9, 7, 3}, 0.2));
  EXPECT_LE(flat.placing.extent.x(), 240);
  EXPECT_LE(flat.placing.extent.y(), 200);
  EXPECT_GE(flat.placing.room, 1);
  EXPECT_LT(flat.placing.room, 1.01);
  const double reach = flat.hub.diameter / 2 + 5;
  EXPECT_GE(flat.positions.row(0).minCoeff(), reach);
  EXPECT_LE(flat.positions.row(0).maxCoeff(), 250 - reach);
  EXPECT_GE(flat.positions.row(1).minCoeff(), reach);
  EXPECT_LE(flat.positions.row(1).maxCoeff(), 210 - reach);
}

TEST(PrintPlan, ALongSheetLiesAcrossTheBed) {
  const PrintPlan strip = plan(flatGrid({31, 4, 2}, 0.2), {.passes = 6});
  EXPECT_GT(strip.placing.degrees, 30);
  EXPECT_LT(strip.placing.degrees, 45);
}

TEST(PrintPlan, HeightsAreThoseAfterTheBath) {
  const PrintPlan chair = plan(flatGrid({9, 7, 3}, 0.2), {.scale = 13.85});
  EXPECT_NEAR(chair.heights.spacing, 4.155, 1e-9);
  EXPECT_NEAR(chair.heights.tube, 3.12, 0.005);  // The prototype's.
  EXPECT_NEAR(chair.heights.tube * 1.05 + 0.8 * 1.1, chair.heights.spacing, 1e-12);
  EXPECT_NEAR(chair.heights.strutSwollen, 1.216, 1e-12);
  EXPECT_NEAR(chair.strutWidth(), 1.316, 0.001);
}

TEST(PrintPlan, WhatIsLaidIsWhatWasDesignedUpToRounding) {
  const StrutGrid grid = randomGrid({8, 6, 2}, 0.05, 0.25, 3);
  const PrintPlan laid = plan(grid);
  EXPECT_TRUE(laid.figures.outOfRange.empty());
  forEachStrut(grid.shape, [&](const Strut& strut) {
    const double printed = laid.enlargement * lengthAt(grid.positions, strut);
    const double change = std::abs(valueAt(laid.rest, strut) - valueAt(grid.rest, strut));
    EXPECT_LE(change, strut.isLateral() ? printed * laid.figures.largestRounding + 1e-12 : 0);
  });
  EXPECT_LT(laid.figures.largestRounding, 0.025);
}

TEST(PrintPlan, EnlargementMeetsTheRange) {
  // Without hubs' share the middle of -8 ... 42 % is 17 %: struts that must grow are printed
  // smaller, those that must shrink more than they can, larger.
  for (const double shrink : {-0.15, 0.0, 0.17, 0.3, 0.45}) {
    const PrintPlan laid = plan(flatGrid({6, 5, 2}, shrink));
    EXPECT_TRUE(laid.figures.outOfRange.empty()) << shrink;
    EXPECT_NEAR(valueAt(laid.rest, Strut{0, 1, Strut::Direction::u, 0}), 1 - shrink, 0.02);
  }
}

TEST(PrintPlan, EnlargementIsTheNumberThatItsDecimalsSay) {
  for (const double shrink : {-0.2, -0.1, 0.0, 0.1, 0.2, 0.3, 0.4}) {
    const double enlargement = plan(flatGrid({6, 5, 2}, shrink)).enlargement;
    EXPECT_EQ(enlargement, std::round(1000 * enlargement) / 1000);
  }
}

TEST(PrintPlan, StrutsOutOfRangeAreCounted) {
  StrutGrid grid = flatGrid({6, 5, 2}, 0.2);
  grid.rest.u[0] = 0.4;
  grid.rest.v[7] = 1.3;
  const PrintPlan laid = plan(grid, {.enlargement = 1.0});
  ASSERT_EQ(laid.figures.outOfRange.size(), 2u);
  EXPECT_EQ(laid.figures.tooMuch, 1);
  EXPECT_EQ(laid.figures.tooLittle, 1);
  const StrutOutOfRange& worst = laid.figures.outOfRange.front();
  EXPECT_EQ(worst.strut.from, 7);
  EXPECT_NEAR(worst.wanted, -0.3, 1e-12);
  EXPECT_EQ(valueAt(laid.shareAlong, worst.strut), 0);
}

TEST(PrintPlan, RefusalsNameAWayOut) {
  const StrutGrid grid = flatGrid({9, 7, 3}, 0.2);
  EXPECT_THAT(refusal(grid, {.scale = 40, .enlargement = 1}),
              HasSubstr("the sheet does not fit 250 x 210 mm: at most 29.5 mm per unit"));
  EXPECT_EQ(
      refusal(grid, {.scale = 5.6, .enlargement = 1, .passes = 2}),
      "330 struts are too short for hubs of 3.66 mm at 5.6 mm per unit, the shortest is 5.60 mm: "
      "5.67 mm per unit would do, or a thinner pin (--pin), fewer rings (--loops) or fewer "
      "nodes");
  EXPECT_THAT(
      refusal(grid, {.scale = 4, .enlargement = 1}),
      HasSubstr("tiers are 1.20 mm apart, but a strut of 0.80 mm swells to 1.22 mm: 4.72 mm "
                "per unit would do, or fewer passes"));
  EXPECT_EQ(refusal(grid, {.scale = 4.73, .enlargement = 1.3}), "");
}

TEST(PrintPlan, RefusesSharpCorners) {
  StrutGrid grid = flatGrid({4, 4, 1}, 0.2);
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) grid.positions(0, 4 * j + i) += 3.0 * j;
  }
  EXPECT_THAT(refusal(grid, {.scale = 12, .enlargement = 1}),
              HasSubstr("corners are so sharp that struts of 1.32 mm meet"));
}

TEST(PrintPlan, RefusesWhatThePrinterCannotLay) {
  PrintMaterial material = sampleMaterial();
  material.strut.passHeight = 0.04;
  EXPECT_THAT(
      refusal(flatGrid({4, 4, 2}, 0.2), {}, samplePrinter(), material),
      HasSubstr("the lowest passes are 0.04 mm high; Prusa MK4, 0.4 mm lays 0.05 to 0.3 mm"));
  Printer printer = samplePrinter();
  printer.height = 5;
  EXPECT_THAT(refusal(flatGrid({4, 4, 2}, 0.2), {}, printer),
              HasSubstr("mm high, the printer 5 mm"));
  printer = samplePrinter();
  printer.bedX = 12;
  EXPECT_EQ(refusal(flatGrid({4, 4, 2}, 0.2), {}, printer),
            "a hub of 3.66 mm does not fit what a margin of 5 mm leaves of 12 x 210 mm");
  printer = samplePrinter();
  printer.margin = 104;
  EXPECT_THAT(refusal(flatGrid({4, 4, 2}, 0.2), {.scale = 20}, printer),
              testing::AllOf(HasSubstr("a hub of 3.66 mm does not fit what a margin of 104 mm"),
                             testing::Not(HasSubstr("nan"))));
  material = sampleMaterial();
  material.hub.heightChange = 0.75;
  EXPECT_THAT(refusal(flatGrid({9, 7, 3}, 0.2), {.scale = 4.8, .enlargement = 1.3}, samplePrinter(),
                      material),
              HasSubstr("hubs leave tubes a height of 0.04 mm"));
  StrutGrid uneven = flatGrid({4, 4, 2}, 0.2);
  uneven.rest.w[3] = 0.4;
  EXPECT_THAT(refusal(uneven), HasSubstr("posts of 0.3 to 0.4 units"));
}

TEST(PrintPlan, OfRandomGridsIsInBoundsOrCounted) {
  for (unsigned seed = 0; seed < 40; ++seed) {
    const StrutGrid grid = randomGrid({3 + static_cast<int>(seed) % 7, 4, 2}, -0.3, 0.6, seed);
    const PrintPlan laid = plan(grid, {.scale = 15});
    const StrutLay lay = strutLayOf(laid.material, laid.hub.diameter);
    std::size_t outside = 0;
    forEachLateralStrut(grid.shape, [&](const Strut& strut) {
      const double share = valueAt(laid.shareAlong, strut);
      EXPECT_TRUE(share >= 0 && share <= 1);
      const double length = laid.scale * laid.enlargement * lengthAt(grid.positions, strut);
      const double shrink = 1 - valueAt(grid.rest, strut) * laid.scale / length;
      const ShrinkRange bounds = lay.bounds(length);
      outside += shrink > bounds.most + 1e-6 || shrink < bounds.least - 1e-6 ? 1 : 0;
    });
    EXPECT_EQ(outside, laid.figures.outOfRange.size());
  }
}

TEST(ConvexOutline, OfAGridIsItsCorners) {
  const StrutGrid grid = flatGrid({5, 4, 2}, 0);
  const Eigen::Matrix2Xd outline = convexOutline(grid.positions.topRows<2>());
  ASSERT_EQ(outline.cols(), 4);
  EXPECT_EQ(outline.col(0), Eigen::Vector2d(0, 0));
  EXPECT_EQ(outline.col(1), Eigen::Vector2d(4, 0));
  EXPECT_EQ(outline.col(2), Eigen::Vector2d(4, 3));
}

}  // namespace
}  // namespace morphgrid
