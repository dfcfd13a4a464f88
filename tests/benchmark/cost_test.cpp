#include "benchmark/cost.h"

#include <gtest/gtest.h>

namespace morphgrid {
namespace {

TEST(Median, IsTheMiddleOneInOrder) {
  EXPECT_EQ(median({7}), 7);
  EXPECT_EQ(median({9, 1, 4}), 4);
  EXPECT_EQ(median({5, 100, 2, 3, 4}), 4);
}

TEST(Median, OfAnEvenNumberIsTheLargerOfTheMiddleTwo) {
  EXPECT_EQ(median({4, 1}), 4);
  EXPECT_EQ(median({1, 8, 2, 4}), 4);
}

}  // namespace
}  // namespace morphgrid
