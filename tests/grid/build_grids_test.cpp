#include "grid/build_grids.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"

namespace morphgrid {
namespace {

GridDesign smallDesign() { return designFromBendAngles({3, 2, 3, 0.2, 1.5, 0.5, -0.5, 0.3, 0.3}); }

TEST(InPlaneGrid, IsOneLayerOfSquareCells) {
  const StrutGrid grid = inPlaneGrid(smallDesign(), {}, Scaling::normalised);
  EXPECT_EQ(grid.shape, (GridShape{4, 3, 1}));
  EXPECT_EQ(grid.positions.col(grid.shape.index(2, 1, 0)), Eigen::Vector3d(3, 1.5, 0));
  for (const Strut& strut : listStruts(grid.shape)) {
    EXPECT_EQ(valueAt(grid.rest, strut), 1.5);
    EXPECT_EQ(valueAt(grid.stiffness, strut), 5);
  }
  EXPECT_NO_THROW(validate(grid));
}

TEST(StackedGrid, CopiesThePrintedLayerAndShortensTheConcaveSide) {
  const GridDesign design = smallDesign();
  const Eigen::Matrix3Xd printed = inPlaneGrid(design, {}, Scaling::normalised).positions;
  const StrutGrid grid = stackedGrid(design, {}, Scaling::normalised, printed);
  EXPECT_EQ(grid.shape, (GridShape{4, 3, 3}));
  for (int k = 0; k < 3; ++k) {
    EXPECT_EQ(grid.positions.col(grid.shape.index(3, 2, k)), Eigen::Vector3d(4.5, 3, 0.2 * k));
  }
  const double shrunk = 1.5 - 2 * 2 * 0.2 * std::sin(0.25);
  EXPECT_EQ(grid.rest.u[grid.shape.index(0, 0, 0)], 1.5);  // theta > 0: convex below
  EXPECT_NEAR(grid.rest.u[grid.shape.index(0, 0, 2)], shrunk, 1e-15);
  EXPECT_EQ(grid.rest.u[grid.shape.index(2, 0, 2)], 1.5);  // theta < 0: convex above
  EXPECT_NEAR(grid.rest.u[grid.shape.index(2, 0, 0)], shrunk, 1e-15);
  EXPECT_EQ(grid.rest.w[grid.shape.index(1, 1, 1)], 0.2);
  EXPECT_EQ(grid.rest.w[grid.shape.index(1, 1, 2)], 0);
  EXPECT_EQ(grid.stiffness.w[grid.shape.index(1, 1, 1)], 40);
  EXPECT_NO_THROW(validate(grid));
}

TEST(StackedGrid, ShapeOpScalingDividesByTheSquareOfTheRestLength) {
  const GridDesign design = smallDesign();
  const Eigen::Matrix3Xd printed = inPlaneGrid(design, {}, Scaling::shapeop).positions;
  const StrutGrid grid = stackedGrid(design, {}, Scaling::shapeop, printed);
  for (const Strut& strut : listStruts(grid.shape)) {
    const double rest = valueAt(grid.rest, strut);
    const double initial = (grid.positions.col(strut.to) - grid.positions.col(strut.from)).norm();
    const double weight = strut.direction == Strut::Direction::w ? 40 : 5;
    EXPECT_NEAR(valueAt(grid.stiffness, strut), weight * initial / (rest * rest), 1e-12);
  }
}

TEST(GridShape, CountsItsStruts) {
  for (const GridShape shape : {GridShape{2, 2, 1}, GridShape{5, 3, 2}, GridShape{4, 7, 5}}) {
    EXPECT_EQ(shape.strutCount(), static_cast<int>(listStruts(shape).size()));
  }
}

TEST(Validate, NamesWhatIsWrong) {
  const StrutGrid good = inPlaneGrid(smallDesign(), {}, Scaling::normalised);
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
  grid.angleWeight = -1;
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
