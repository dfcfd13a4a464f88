#include "view/overlay.h"

#include <gtest/gtest.h>

namespace morphgrid {
namespace {

TEST(RoundLength, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_DOUBLE_EQ(roundLength(1), 1);
  EXPECT_DOUBLE_EQ(roundLength(1.9), 1);
  EXPECT_DOUBLE_EQ(roundLength(4.9), 2);
  EXPECT_DOUBLE_EQ(roundLength(73), 50);
  EXPECT_DOUBLE_EQ(roundLength(0.0023), 0.002);
}

TEST(RoundLength, IsAtMostWhatIsAllowedAndMoreThanTwoFifthsOfIt) {
  for (double largest = 1e-6; largest < 1e6; largest *= 1.07) {
    EXPECT_LE(roundLength(largest), largest * (1 + 1e-12));
    EXPECT_GT(roundLength(largest), 0.4 * largest);
  }
}

}  // namespace
}  // namespace morphgrid
