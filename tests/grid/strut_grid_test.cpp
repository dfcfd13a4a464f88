#include "grid/strut_grid.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"

namespace morphgrid {
namespace {

/// 4 x 3 vertices.
StrutGrid flatLayer() {
  Eigen::Matrix3Xd points(3, 12);
  for (int n = 0; n < 12; ++n) {
    points.col(n) = Eigen::Vector3d(n % 4, n / 4, 0);
  }
  return layerAtRest({4, 3, 1}, 1, points);
}

TEST(Validate, NamesWhatIsWrong) {
  const StrutGrid good = flatLayer();
  StrutGrid grid = good;
  grid.rest.u[0] = -1;
  EXPECT_THROW(validate(grid), InputError);
  grid = good;
  grid.stiffness.v[0] = std::nan("");
  EXPECT_THROW(validate(grid), InputError);
  grid = good;
  grid.positions.col(1) = grid.positions.col(0);
  EXPECT_THROW(validate(grid), InputError);
  grid = good;
  grid.positions(2, 3) = INFINITY;
  EXPECT_THROW(validate(grid), InputError);
  grid = good;
  grid.rest.w.pop_back();
  EXPECT_THROW(validate(grid), InputError);
  grid = good;
  grid.spacing = 0;
  EXPECT_THROW(validate(grid), InputError);
  grid = good;
  grid.weights.angle = -1;
  EXPECT_THROW(validate(grid), InputError);
  grid = good;
  grid.shape = {1, 12, 1};
  EXPECT_THROW(validate(grid), InputError);
}

TEST(LayerAtRest, HasNoStrain) {
  const Eigen::Matrix3Xd points = Eigen::Matrix3Xd::Random(3, 6);
  const StrutGrid grid = layerAtRest({3, 2, 4}, 0.5, points);
  EXPECT_EQ(grid.shape, (GridShape{3, 2, 1}));
  EXPECT_EQ(grid.positions, points);
  EXPECT_DOUBLE_EQ(grid.rest.u[1], (points.col(2) - points.col(1)).norm());
  EXPECT_DOUBLE_EQ(grid.rest.v[1], (points.col(4) - points.col(1)).norm());
  EXPECT_NO_THROW(validate(grid));
}

TEST(MiddleLayer, IsTheMiddleOneOrTheMeanOfTwo) {
  for (const int layers : {1, 2, 3, 4}) {
    const GridShape shape{2, 2, layers};
    Eigen::Matrix3Xd positions(3, shape.vertexCount());
    for (int n = 0; n < shape.vertexCount(); ++n) {
      positions.col(n) = Eigen::Vector3d(n % 4, 0, n / 4);
    }
    const Eigen::Matrix3Xd middle = middleLayer(shape, positions);
    ASSERT_EQ(middle.cols(), 4);
    EXPECT_EQ(middle.col(3), Eigen::Vector3d(3, 0, (layers - 1) / 2.0));
  }
}

}  // namespace
}  // namespace morphgrid
