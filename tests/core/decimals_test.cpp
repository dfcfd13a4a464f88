#include "core/decimals.h"

#include <gtest/gtest.h>

namespace morphgrid {
namespace {

TEST(Decimals, AreAsManyAsTheStepNeeds) {
  EXPECT_EQ(decimalsFor(1000), 0);
  EXPECT_EQ(decimalsFor(1), 0);
  EXPECT_EQ(decimalsFor(0.02), 2);
  EXPECT_EQ(decimalsFor(0.01), 2);
  EXPECT_EQ(decimalsFor(4e-9), 9);
}

TEST(Decimals, KeepLargeNumbersWhole) {
  EXPECT_EQ(inDecimals(5412343.5199999996, 2), "5412343.52");
  EXPECT_EQ(inDecimals(-1234567.8, 0), "-1234568");
  EXPECT_EQ(inDecimals(1e300, 3), "1e+300");
}

TEST(Decimals, HaveNoZerosAtTheEnd) {
  EXPECT_EQ(inDecimals(1.5, 4), "1.5");
  EXPECT_EQ(inDecimals(-2, 3), "-2");
  EXPECT_EQ(inDecimals(-0.0001, 2), "0");
  EXPECT_EQ(inDecimals(100, 0), "100");
}

TEST(Decimals, ReadBackAsRounded) {
  for (const double value : {0.123456, -98.7654, 452308.2704, 3e-8}) {
    EXPECT_EQ(std::stod(inDecimals(value, 3)), roundedTo(value, 3)) << value;
  }
  EXPECT_EQ(roundedTo(3.25e-20, 21), 3.25e-20);  // More digits than a double has.
}

TEST(Decimals, OfSoManyDigits) {
  EXPECT_EQ(roundedToDigits(1234.6, 3), 1235);  // Whole numbers stay whole.
  EXPECT_EQ(roundedToDigits(0.0123456, 3), 0.0123);
  EXPECT_EQ(roundedToDigits(-8.5512, 2), -8.6);
}

}  // namespace
}  // namespace morphgrid
