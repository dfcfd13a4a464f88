#include "core/number_range.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace morphgrid {
namespace {

TEST(NumberRange, BoundsAreInOrOut) {
  EXPECT_FALSE(between(0, 1).contains(0));
  EXPECT_TRUE(between(0, 1).contains(0.5));
  EXPECT_FALSE(between(0, 1).contains(1));
  EXPECT_FALSE(aboveUpTo(0, 1).contains(0));
  EXPECT_TRUE(aboveUpTo(0, 1).contains(1));
  EXPECT_TRUE(fromTo(0, 1).contains(0));
  EXPECT_TRUE(atLeast(0).contains(0));
  EXPECT_FALSE(above(0).contains(0));
  EXPECT_TRUE(NumberRange().contains(-1e300));
}

TEST(NumberRange, HoldsFiniteNumbersOnly) {
  for (const NumberRange& range : {NumberRange(), atLeast(0), fromTo(-1, 1)}) {
    EXPECT_FALSE(range.contains(NAN));
    EXPECT_FALSE(range.contains(INFINITY));
    EXPECT_FALSE(range.contains(-INFINITY));
  }
}

TEST(NumberRange, InWords) {
  EXPECT_EQ(describe(NumberRange()), "a finite number");
  EXPECT_EQ(describe(above(0)), "a number > 0");
  EXPECT_EQ(describe(atLeast(0.5)), "a number >= 0.5");
  EXPECT_EQ(describe(NumberRange{.high = 2}), "a number < 2");
  EXPECT_EQ(describe(aboveUpTo(0, 1)), "a number > 0 and <= 1");
  EXPECT_EQ(describe(fromTo(-std::numbers::pi, std::numbers::pi)), "a number >= -pi and <= pi");
  EXPECT_EQ(describe(IntegerRange()), "an integer");
  EXPECT_EQ(describe(IntegerRange{1, 64}), "an integer >= 1 and <= 64");
  EXPECT_EQ(describe(IntegerRange{.low = 0}), "an integer >= 0");
}

}  // namespace
}  // namespace morphgrid
