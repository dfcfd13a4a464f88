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

}  // namespace
}  // namespace morphgrid
