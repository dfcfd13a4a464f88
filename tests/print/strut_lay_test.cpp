#include "print/strut_lay.h"

#include <gtest/gtest.h>

#include "print/bead.h"

namespace morphgrid {
namespace {

constexpr double kHub = 3.66;
constexpr StrutLay kLay{.along = 0.42, .across = -0.08, .hub = 0.05, .hubDiameter = kHub};

TEST(Bead, LinesAPitchApartFillASolid) {
  for (const double height : {0.08, 0.2, 0.45}) {
    const Bead bead{0.45, height};
    EXPECT_NEAR(bead.area(), bead.pitch() * height, 1e-15);
  }
  EXPECT_NEAR((Bead{0.4, 0.4}).area(), std::numbers::pi * 0.04, 1e-15);  // A round one.
  EXPECT_NEAR(2 * (Bead{0.45, 0.08}).pitch() + 0.45, 1.316, 1e-3);       // Three lines: 1.32 mm.
}

TEST(StrutLay, WithoutHubsTheBoundsAreTheMaterials) {
  const ShrinkRange bounds = StrutLay{0.42, -0.08, 0.05, 0}.bounds(12);
  EXPECT_DOUBLE_EQ(bounds.least, -0.08);
  EXPECT_DOUBLE_EQ(bounds.most, 0.42);
}

TEST(StrutLay, HubsTakeTheirShareOfTheBounds) {
  // 42 % become 33 % at 15 mm, as the specification of the prototype has it.
  EXPECT_NEAR(kLay.bounds(15).most, 0.33, 0.002);
  EXPECT_NEAR(kLay.bounds(15).most, 0.42 * (1 - kHub / 15) + 0.05 * kHub / 15, 1e-15);
  EXPECT_NEAR(kLay.bounds(15).least, -0.08 * (1 - kHub / 15) + 0.05 * kHub / 15, 1e-15);
}

TEST(StrutLay, SharesByHand) {
  EXPECT_NEAR(kLay.shrinkAt(0, 13.66), (-0.08 * 10 + 0.05 * kHub) / 13.66, 1e-15);
  EXPECT_NEAR(kLay.shrinkAt(1, 13.66), (0.42 * 10 + 0.05 * kHub) / 13.66, 1e-15);
  EXPECT_NEAR(kLay.shrinkAt(0.5, 13.66), (0.17 * 10 + 0.05 * kHub) / 13.66, 1e-15);
}

TEST(StrutLay, ShareAndShrinkAreInverse) {
  for (double length = 6; length < 40; length += 3.7) {
    for (double shrink = -0.05; shrink < 0.4; shrink += 0.03) {
      EXPECT_NEAR(kLay.shrinkAt(kLay.shareFor(shrink, length), length), shrink, 1e-12);
    }
  }
}

TEST(LayableShare, LeavesNoPartShorterThanAZone) {
  EXPECT_EQ(layableShare(-0.3, 10), 0);
  EXPECT_EQ(layableShare(1.3, 10), 1);
  EXPECT_EQ(layableShare(0.04, 10), 0);
  EXPECT_EQ(layableShare(0.06, 10), 0.1);
  EXPECT_EQ(layableShare(0.37, 10), 0.37);
  EXPECT_EQ(layableShare(0.93, 10), 0.9);
  EXPECT_EQ(layableShare(0.96, 10), 1);
  for (double share = 0; share <= 1; share += 0.01) {
    for (const double length : {2.0, 3.1, 5.6, 13.0}) {
      const double laid = layableShare(share, length);
      EXPECT_LE(std::abs(laid - share), kShortestZone / (2 * length) + 1e-12);
      EXPECT_TRUE(laid == 0 || laid * length > kShortestZone - 1e-12);
      EXPECT_TRUE(laid == 1 || (1 - laid) * length > kShortestZone - 1e-12);
    }
  }
}

}  // namespace
}  // namespace morphgrid
