#include "print/print_tolerance.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace morphgrid {
namespace {

using testing::HasSubstr;

TEST(PrintTolerance, QuantilesLieBetweenValues) {
  EXPECT_DOUBLE_EQ(quantileOf({3, 1, 2}, 0.5), 2);
  EXPECT_DOUBLE_EQ(quantileOf({4, 1, 2, 3}, 0.95), 3.85);
  EXPECT_DOUBLE_EQ(quantileOf({7}, 0.95), 7);
}

TEST(PrintTolerance, JumpsAreCountedAndTold) {
  const DisturbedPrints kind{"each tier",
                             {{1, 2, true, false}, {3, 4, true, true}, {2, 6, false, false}}};
  const DisturbedFigures figures = figuresOf(kind.prints);
  EXPECT_DOUBLE_EQ(figures.meanRms, 2);
  EXPECT_DOUBLE_EQ(figures.meanMax, 4);
  EXPECT_DOUBLE_EQ(figures.rms95, 2.9);
  EXPECT_EQ(figures.jumps, 1);
  EXPECT_EQ(figures.unconverged, 1);
  const PrintTolerance tolerance{.request = {.share = 0.1, .samples = 3},
                                 .model = "frame",
                                 .hasTarget = true,
                                 .kinds = {kind},
                                 .struts = {{"strut u 0 1 of tier 2", 0.05, 0.012, 0.013, -0.011}},
                                 .tiers = {}};
  const std::string table = toleranceTable(tolerance);
  EXPECT_THAT(table, HasSubstr("distance to the target, % RMS / most, by the model frame"));
  EXPECT_THAT(table, HasSubstr("2 / 2.9 / 4 %, 1 in another equilibrium, 1 not at rest"));
  EXPECT_THAT(
      table,
      HasSubstr("+0.013 if it shrinks more (to first order +0.012), -0.011 if less; the layer "
                "moves by 0.05 %"));
  ASSERT_EQ(toleranceNotices(tolerance).size(), 1u);
  EXPECT_THAT(toleranceNotices(tolerance)[0], HasSubstr("1 of 3 prints with errors of 10 %"));
  EXPECT_THAT(tolerancePage(tolerance), HasSubstr("<td>each tier</td>"));
}

}  // namespace
}  // namespace morphgrid
