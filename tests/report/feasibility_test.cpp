#include "report/feasibility.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <functional>
#include <numbers>

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

Matrix3Xd positionsOf(const GridShape& shape,
                      const std::function<Vector3d(int i, int j, int k)>& pointAt) {
  Matrix3Xd positions(3, shape.vertexCount());
  for (int k = 0; k < shape.layers; ++k) {
    for (int j = 0; j < shape.verticesV; ++j) {
      for (int i = 0; i < shape.verticesU; ++i) {
        positions.col(shape.index(i, j, k)) = pointAt(i, j, k);
      }
    }
  }
  return positions;
}

Matrix3Xd flat(const GridShape& shape) {
  return positionsOf(shape, [](int i, int j, int k) { return Vector3d(i, j, 0.3 * k); });
}

/// Along u a spiral with the given turns whose windings are `pitch` apart, struts about 1 long.
Matrix3Xd rolled(const GridShape& shape, double turns, double pitch) {
  const double angle = 2 * std::numbers::pi * turns / (shape.verticesU - 1);
  return positionsOf(shape, [&](int i, int j, int k) {
    const double phi = angle * i;
    const double radius = 1 / angle + pitch * phi / (2 * std::numbers::pi) - 0.1 * k;
    return Vector3d(radius * std::sin(phi), j, -radius * std::cos(phi));
  });
}

TEST(Cells, OfAFlatGridAreWhole) {
  for (const int layers : {1, 2, 3}) {
    const GridShape shape{5, 4, layers};
    const CellFigures cells = examineCells(shape, flat(shape));
    EXPECT_EQ(cells.inverted, 0);
    EXPECT_EQ(cells.collapsed, 0);
    EXPECT_NEAR(cells.smallestRelativeArea, 1, 1e-12);
  }
}

TEST(Cells, RelativeAreaIsTheSineOfAParallelogramsAngle) {
  const GridShape shape{4, 3, 2};
  for (const double angle : {0.1, 0.03, -0.03, -0.1}) {
    const Matrix3Xd sheared = positionsOf(shape, [&](int i, int j, int k) {
      return Vector3d(i + j * std::cos(angle), j * std::sin(angle), 0.3 * k);
    });
    const CellFigures cells = examineCells(shape, sheared);
    EXPECT_NEAR(cells.smallestRelativeArea, std::sin(angle), 1e-12);
    EXPECT_EQ(cells.collapsed, std::abs(angle) < 0.05 ? 12 : 0);
    EXPECT_EQ(cells.inverted, angle < -0.05 ? 12 : 0);
  }
}

TEST(Cells, FoldedCellIsInverted) {
  const GridShape shape{6, 4, 3};
  Matrix3Xd positions = flat(shape);
  for (int j = 0; j < 4; ++j) {  // In the middle layer column 4 folds back over column 3.
    positions.col(shape.index(4, j, 1)).x() = 2.5;
  }
  const CellFigures cells = examineCells(shape, positions);
  EXPECT_EQ(cells.inverted, 3);
  EXPECT_EQ(cells.collapsed, 0);
  EXPECT_EQ(cells.smallest.i, 3);
  EXPECT_EQ(cells.smallest.layer, 1);
}

TEST(Cells, AnAllBentGridIsWhole) {
  const GridShape shape{30, 4, 3};
  for (const double turns : {0.4, 0.9, 2.5}) {
    EXPECT_EQ(examineCells(shape, rolled(shape, turns, 1)).inverted, 0);
    EXPECT_EQ(examineCells(shape, rolled(shape, turns, 1)).collapsed, 0);
  }
}

TEST(Cells, MotionAndScaleDoNotMatter) {
  const GridShape shape{6, 4, 2};
  Matrix3Xd positions = flat(shape);
  positions.col(shape.index(3, 2, 0)) += Vector3d(0.4, 0.3, 0.1);
  const Eigen::Affine3d motion = Eigen::Translation3d(3, 4, 5) *
                                 Eigen::AngleAxisd(2.1, Vector3d(1, 2, 3).normalized()) *
                                 Eigen::Scaling(1e3);
  EXPECT_NEAR(examineCells(shape, motion * positions).smallestRelativeArea,
              examineCells(shape, positions).smallestRelativeArea, 1e-12);
}

TEST(Cells, WithoutSidesAreCollapsed) {
  const GridShape shape{3, 2, 2};
  EXPECT_EQ(examineCells(shape, Matrix3Xd::Zero(3, shape.vertexCount())).collapsed, 4);
}

TEST(SelfIntersection, StripRolledPastItselfCutsThrough) {
  const GridShape shape{41, 4, 3};
  EXPECT_EQ(findSelfIntersection(shape, flat(shape)).cells, 0);
  EXPECT_EQ(findSelfIntersection(shape, rolled(shape, 0.95, 0)).cells, 0);
  EXPECT_EQ(findSelfIntersection(shape, rolled(shape, 1.6, 2)).cells, 0) << "a spiral";
  // The second winding, from i = 31 on, starts inside of the first and ends outside of it.
  const Matrix3Xd through = positionsOf(shape, [](int i, int j, int k) {
    const double phi = 2 * std::numbers::pi * 1.3 * i / 40;
    const double radius = 5 - 0.1 * k + (i < 10 ? 0 : 0.02 * (i - 35.5));
    return Vector3d(radius * std::sin(phi), j, -radius * std::cos(phi));
  });
  const SelfIntersection found = findSelfIntersection(shape, through);
  EXPECT_GE(found.cells, 6) << "3 cells of a row, of both windings";
  EXPECT_EQ(found.first.layer, 1);
}

TEST(CloseStruts, TwoLayersAtAKnownDistance) {
  const GridShape shape{4, 3, 2};
  EXPECT_EQ(findCloseStruts(shape, flat(shape), 0.299).count, 0);
  const CloseStruts close = findCloseStruts(shape, flat(shape), 0.301);
  EXPECT_EQ(close.count, shape.lateralStrutCount()) << "each runs beside one of the other layer";
  EXPECT_NEAR(close.smallestClearance, 0.3, 1e-12);
}

TEST(CloseStruts, ThePlaceIsNamed) {
  const GridShape shape{6, 5, 2};
  Matrix3Xd positions = flat(shape);
  positions.col(shape.index(3, 2, 0)).z() += 0.2;
  const CloseStruts close = findCloseStruts(shape, positions, 0.25);
  EXPECT_GT(close.count, 0);
  EXPECT_EQ(close.closest.layer, 0);
  EXPECT_NEAR(close.closest.i, 3, 1);
  EXPECT_NEAR(close.closest.j, 2, 1);
}

TEST(Advice, IsGivenWhereSomethingIsWrong) {
  const GridShape shape{6, 4, 2};
  Matrix3Xd positions = flat(shape);
  const Feasibility well = examineFeasibility(shape, positions, 0.1);
  EXPECT_THAT(adviseOn(well), IsEmpty());
  EXPECT_FALSE(examineFeasibility(shape, positions, {}).closeStruts);
  EXPECT_TRUE(well.closeStruts);

  for (int k = 0; k < 2; ++k) {
    for (int j = 0; j < 4; ++j) {
      positions.col(shape.index(4, j, k)).x() = 1.5;
    }
  }
  EXPECT_THAT(
      adviseOn(examineFeasibility(shape, positions, 0.35)),
      ElementsAre(HasSubstr("6 cells are inverted and 0 collapsed, worst the cell at (3, 0) "
                            "of layer 0"),
                  HasSubstr("cells cut through another"),
                  HasSubstr("closer to another than grid.strut_thickness = 0.35")));
}

}  // namespace
}  // namespace morphgrid
