#include "print/check_overlaps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/print/print_samples.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;

PrintPlan soundPlan() {
  return planPrint("overlaps", flatGrid({5, 4, 2}, 0.2), samplePrinter(), sampleMaterial(),
                   {.scale = 15, .enlargement = 1.0});
}

TEST(FindOverlaps, ThereAreNoneInASoundSheet) { EXPECT_FALSE(findOverlaps(soundPlan())); }

TEST(FindOverlaps, HubsMustNotTouch) {
  PrintPlan plan = soundPlan();
  plan.positions.col(0) = plan.positions.col(6) + Eigen::Vector2d(3.6, 0.5);
  EXPECT_THAT(findOverlaps(plan).value_or(""), HasSubstr("1 hubs of 3.66 mm overlap"));
}

TEST(FindOverlaps, StrutsMustNotRunIntoHubs) {
  PrintPlan plan = soundPlan();
  // The corner's hub beside the strut from 1 to 6; (1.32 + 3.66) / 2 mm would do.
  const Eigen::Vector2d middle = (plan.positions.col(1) + plan.positions.col(6)) / 2;
  const Eigen::Vector2d aside = (plan.positions.col(0) - plan.positions.col(1)).normalized();
  plan.positions.col(0) = middle + 2.4 * aside;
  EXPECT_THAT(
      findOverlaps(plan).value_or(""),
      HasSubstr("1 struts cross others or run into their hubs, the first strut v 1 0 of tier 1, "
                "0 hubs"));
  plan.positions.col(0) = middle + 2.6 * aside;
  EXPECT_FALSE(findOverlaps(plan));
}

TEST(FindOverlaps, ASheetThatComesAroundIsRefused) {
  StrutGrid grid = flatGrid({11, 2, 2}, 0.2);
  forEachVertex(grid.shape, [&](const GridPlace& place) {  // 380 degrees of a ring.
    const double angle = place.i * 38 * std::numbers::pi / 180;
    grid.positions.col(grid.shape.index(place)).head<2>() =
        (5 - place.j) * Eigen::Vector2d(std::cos(angle), std::sin(angle));
  });
  forEachLateralStrut(grid.shape, [&](const Strut& strut) {
    valueAt(grid.rest, strut) = 0.8 * lengthAt(grid.positions, strut);
  });
  try {
    planPrint("ring", grid, samplePrinter(), sampleMaterial(), {});
    FAIL() << "what overlaps is not refused";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("the sheet overlaps itself: "));
  }
}

}  // namespace
}  // namespace morphgrid
