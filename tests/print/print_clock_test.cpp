#include "print/print_clock.h"

#include <gtest/gtest.h>

#include <cmath>

namespace morphgrid {
namespace {

TEST(PrintClock, ALongMoveIsATrapezoid) {
  PrintClock clock(8);
  clock.add({30, 40, 0}, 100, 1000);
  // From 4 to 100 mm/s and back at 1000 mm/s^2, the rest of 50 mm at 100.
  const double ramps = (100.0 * 100 - 4 * 4) / 1000;
  EXPECT_NEAR(clock.take(), 2 * (100 - 4) / 1000.0 + (50 - ramps) / 100, 1e-12);
  EXPECT_EQ(clock.take(), 0);
}

TEST(PrintClock, AShortMoveIsATriangle) {
  PrintClock clock(8);
  clock.add({1, 0, 0}, 1000, 1000);
  const double top = std::sqrt((2 * 1000 * 1 + 2 * 4 * 4) / 2.0);
  EXPECT_NEAR(clock.take(), 2 * (top - 4) / 1000, 1e-12);
}

TEST(PrintClock, AStraightLineIsNotSlowedByItsJunctions) {
  PrintClock whole(8);
  whole.add({20, 0, 0}, 60, 800);
  PrintClock cut(8);
  for (int n = 0; n < 10; ++n) cut.add({2, 0, 0}, 60, 800);
  EXPECT_NEAR(cut.take(), whole.take(), 1e-9);
}

TEST(PrintClock, ACornerIsPassedAtTheJerksSpeed) {
  PrintClock clock(10);
  clock.add({50, 0, 0}, 50, 500);
  clock.add({0, 50, 0}, 50, 500);
  // Each axis changes by the speed itself: 10 mm/s there.
  const double middle = 10, ends = 5;
  const double ramps = (2 * 50.0 * 50 - middle * middle - ends * ends) / (2 * 500);
  const double one = (2 * 50 - middle - ends) / 500 + (50 - ramps) / 50;
  EXPECT_NEAR(clock.take(), 2 * one, 1e-12);
}

}  // namespace
}  // namespace morphgrid
