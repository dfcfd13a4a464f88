#include "design/build_grids.h"

#include <gtest/gtest.h>

#include <cmath>

namespace morphgrid {
namespace {

GridDesign smallDesign() { return designFromBendAngles({3, 2, 1.5, 0.5, -0.5, 0.3, 0.3}, 3, 0.2); }

TEST(InPlaneGrid, IsOneLayerOfSquareCells) {
  const StrutGrid grid = inPlaneGrid(smallDesign(), {}, Scaling::normalised);
  EXPECT_EQ(grid.shape, (GridShape{4, 3, 1}));
  EXPECT_EQ(grid.positions.col(grid.shape.index(2, 1, 0)), Eigen::Vector3d(3, 1.5, 0));
  forEachStrut(grid.shape, [&](const Strut& strut) {
    EXPECT_EQ(valueAt(grid.rest, strut), 1.5);
    EXPECT_EQ(valueAt(grid.stiffness, strut), 5);
  });
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
  forEachStrut(grid.shape, [&](const Strut& strut) {
    const double rest = valueAt(grid.rest, strut);
    const double initial = (grid.positions.col(strut.to) - grid.positions.col(strut.from)).norm();
    const double weight = strut.direction == Strut::Direction::w ? 40 : 5;
    EXPECT_NEAR(valueAt(grid.stiffness, strut), weight * initial / (rest * rest), 1e-12);
  });
}

}  // namespace
}  // namespace morphgrid
