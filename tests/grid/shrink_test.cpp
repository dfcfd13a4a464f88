#include "grid/shrink.h"

#include <gtest/gtest.h>

namespace morphgrid {
namespace {

TEST(Shrinks, AreSharesOfThePrintedLength) {
  StrutGrid grid;
  grid.shape = {2, 2, 2};
  grid.positions.resize(3, 8);
  grid.positions << 0, 2, 0, 2, 0, 2, 0, 2, 0, 0, 4, 4, 0, 0, 4, 4, 0, 0, 0, 0, 1, 1, 1, 1;
  grid.rest = StrutValues(grid.shape);
  forEachStrut(grid.shape, [&](const Strut& strut) { valueAt(grid.rest, strut) = 1; });
  grid.rest.u[2] = 3;
  const StrutValues shrinks = computeShrinks(grid);
  EXPECT_EQ(shrinks.u[0], 0.5);
  EXPECT_EQ(shrinks.u[2], -0.5) << "has to grow";
  EXPECT_EQ(shrinks.v[5], 0.75);
  EXPECT_EQ(shrinks.w[3], 0);
  EXPECT_EQ(shrinks.u[1], 0) << "no such strut";
}

TEST(ShrinkBounds, WithoutHubsAreTheMaterials) {
  const ShrinkBounds bounds{{-0.08, 0.42}, 0.05, 0};
  EXPECT_EQ(bounds.at(3), (ShrinkRange{-0.08, 0.42}));
  EXPECT_NEAR(bounds.longestFor(0.58), 1, 1e-15);
  EXPECT_NEAR(bounds.shortestFor(1.08), 1, 1e-15);
}

TEST(ShrinkBounds, HubsTakeTheirShare) {
  const ShrinkBounds bounds{{-0.08, 0.42}, 0.05, 3.66};
  // By hand: [c (1 - D/P) + b D/P, a (1 - D/P) + b D/P] with D/P = 0.244.
  EXPECT_NEAR(bounds.at(15).most, 0.42 * 0.756 + 0.05 * 0.244, 1e-15);
  EXPECT_NEAR(bounds.at(15).least, -0.08 * 0.756 + 0.05 * 0.244, 1e-15);
  // A strut that is all hub loses what hubs do.
  EXPECT_NEAR(bounds.at(3.66).most, 0.05, 1e-15);
  EXPECT_NEAR(bounds.at(2).least, 0.05, 1e-15);
}

TEST(ShrinkBounds, KnowTheLengthsThatMeetThem) {
  const ShrinkBounds bounds{{-0.08, 0.42}, 0.05, 3.66};
  for (const double rest : {6.0, 11.0, 30.0}) {
    const double longest = bounds.longestFor(rest);
    const double shortest = bounds.shortestFor(rest);
    EXPECT_NEAR(longest * (1 - bounds.at(longest).most), rest, 1e-12);
    EXPECT_NEAR(shortest * (1 - bounds.at(shortest).least), rest, 1e-12);
    EXPECT_LT(shortest, longest);
  }
}

TEST(ShrinkShares, AreOfWhatEachStrutCan) {
  StrutGrid grid{.shape = {3, 2, 1}, .spacing = 1};
  grid.positions = Eigen::Matrix3Xd::Zero(3, 6);
  forEachVertex(grid.shape, [&](const GridPlace& place) {
    grid.positions.col(grid.shape.index(place)) << 10 * place.i + 5 * (place.i > 1), place.j * 10,
        0;
  });
  grid.rest = StrutValues(grid.shape);
  const ShrinkBounds bounds{{-0.08, 0.42}, 0.05, 3.66};
  forEachLateralStrut(grid.shape, [&](const Strut& strut) {
    const double length = lengthAt(grid.positions, strut);
    valueAt(grid.rest, strut) = length * (1 - 0.5 * bounds.at(length).most);
  });
  const StrutValues shares = computeShrinkShares(grid, bounds);
  forEachLateralStrut(grid.shape,
                      [&](const Strut& strut) { EXPECT_NEAR(valueAt(shares, strut), 0.5, 1e-12); });
}

}  // namespace
}  // namespace morphgrid
