#include "core/bounding_diagonal.h"

#include <gtest/gtest.h>

namespace morphgrid {
namespace {

TEST(BoundingDiagonal, IsThatOfTheAxisParallelBox) {
  Eigen::Matrix3Xd points(3, 3);
  points << 1, 4, 2,  //
      5, 5, 9,        //
      -2, 0, 10;
  EXPECT_DOUBLE_EQ(boundingDiagonal(points), 13);  // The box is 3 x 4 x 12.
  EXPECT_EQ(boundingDiagonal(points.leftCols(1)), 0);
}

}  // namespace
}  // namespace morphgrid
