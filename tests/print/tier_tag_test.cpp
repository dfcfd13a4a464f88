#include "print/tier_tag.h"

#include <gtest/gtest.h>

#include "tests/print/print_samples.h"

namespace morphgrid {
namespace {

PrintPlan planOf(double scale, int tiers) {
  return planPrint("tags", flatGrid({4, 3, tiers}, 0.2), samplePrinter(), sampleMaterial(),
                   {.scale = scale, .enlargement = 1.0});
}

TEST(TierTag, StaysClearOfStruts) {
  const PrintPlan plan = planOf(10, 12);
  const Eigen::Vector2d corner = plan.at({0, 0, 0});
  for (int tier = 0; tier < 12; ++tier) {
    const auto strokes = tagOf(plan, tier);
    ASSERT_GE(strokes.size(), 4u) << tier;
    EXPECT_NEAR((strokes[0][0] - corner).norm(), plan.hub.diameter / 2, 1e-9);
    const double needed = kTagGap + (plan.strutWidth() + plan.printer.lineWidth) / 2;
    for (std::size_t n = 1; n < strokes.size(); ++n) {
      for (const Eigen::Vector2d& point : strokes[n]) {
        EXPECT_GE((point - corner).minCoeff(), needed - 1e-9);
        EXPECT_LE((point - corner).maxCoeff(), 10 - needed + 1e-9);
      }
    }
  }
}

TEST(TierTag, IsLeftOutWhereThereIsNoRoom) { EXPECT_TRUE(tagOf(planOf(6, 2), 0).empty()); }

}  // namespace
}  // namespace morphgrid
