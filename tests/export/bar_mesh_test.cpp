#include "export/bar_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <map>

#include "grid/bar_section.h"
#include "tests/export/export_samples.h"
#include "tests/support/strut_list.h"

namespace morphgrid {
namespace {

using Eigen::Vector3d;

/// The section n of a bar: its corners, counter-clockwise about the bar.
Eigen::Matrix<double, 3, 4> sectionOf(const Eigen::Matrix3Xd& vertices, std::size_t bar, int n) {
  return vertices.middleCols<4>(kBarMeshVertices * static_cast<Eigen::Index>(bar) + 4 * n);
}

TEST(BarMesh, SectionsHaveTheirWidthAndHeightAtRightAngles) {
  const FrameSample sample = frameSample({4, 3, 3});
  const Eigen::Matrix3Xd vertices = barVertices(sample.grid, sample.positions, sample.rotations);
  ASSERT_EQ(vertices.cols(), kBarMeshVertices * sample.grid.shape.strutCount());
  for (int bar = 0; bar < sample.grid.shape.strutCount(); ++bar) {
    for (int n = 0; n <= kBarMeshPieces; ++n) {
      const auto section = sectionOf(vertices, bar, n);
      const Vector3d wide = section.col(1) - section.col(0);
      const Vector3d high = section.col(3) - section.col(0);
      EXPECT_NEAR(wide.norm(), kBarWidth, 1e-12);
      EXPECT_NEAR(high.norm(), kBarHeight, 1e-12);
      EXPECT_NEAR(wide.dot(high), 0, 1e-12);
      EXPECT_LT((section.col(2) - section.col(1) - high).norm(), 1e-12);
    }
  }
}

/// Inside the grid, where bars end in their joints.
TEST(BarMesh, EndsLieAtTheJointsAndTurnWithThem) {
  const FrameSample sample = frameSample({4, 4, 2});
  const GridShape& shape = sample.grid.shape;
  const Eigen::Matrix3Xd vertices = barVertices(sample.grid, sample.positions, sample.rotations);
  const std::vector<Strut> struts = listStruts(shape);
  for (std::size_t bar = 0; bar < struts.size(); ++bar) {
    const Strut& strut = struts[bar];
    if (strut.direction != Strut::Direction::u) {
      continue;
    }
    const GridPlace place = shape.place(strut.from);
    for (const bool isEnd : {false, true}) {
      const int joint = isEnd ? strut.to : strut.from;
      const Eigen::Matrix3d turn = Eigen::Quaterniond(sample.rotations.col(joint)).matrix();
      const bool isBorder = place.i == (isEnd ? shape.cellsU() - 1 : 0);
      const double beyond = !isBorder ? 0 : isEnd ? kBarWidth / 2 : -kBarWidth / 2;
      const auto section = sectionOf(vertices, bar, isEnd ? kBarMeshPieces : 0);
      const Vector3d middle = section.rowwise().mean();
      EXPECT_LT((middle - sample.positions.col(joint) - beyond * turn.col(0)).norm(), 1e-12);
      const Vector3d wide = (section.col(1) - section.col(0)) / kBarWidth;
      EXPECT_LT((wide - turn.col(1)).norm(), 1e-12);
    }
  }
}

/// Straight bars of a grid as printed: prisms of a known volume, without a gap.
TEST(BarMesh, BarsAreClosedAndHaveTheirVolume) {
  FrameSample sample = frameSample({3, 2, 2});
  sample.positions = sample.grid.positions;
  sample.rotations = unturnedJoints(sample.grid.shape.vertexCount());
  const Eigen::Matrix3Xd vertices = barVertices(sample.grid, sample.positions, sample.rotations);
  const Eigen::Matrix3Xi triangles = barTriangles(sample.grid.shape);
  const std::vector<Strut> struts = listStruts(sample.grid.shape);
  ASSERT_EQ(triangles.cols(), kBarMeshTriangles * struts.size());
  std::map<std::pair<int, int>, int> edges;
  for (std::size_t bar = 0; bar < struts.size(); ++bar) {
    double volume = 0;
    for (const auto& corners :
         triangles.middleCols<kBarMeshTriangles>(kBarMeshTriangles * bar).colwise()) {
      const Vector3d a = vertices.col(corners[0]);
      volume += a.dot(Vector3d(vertices.col(corners[1])).cross(vertices.col(corners[2]))) / 6;
      for (int n = 0; n < 3; ++n) {
        ++edges[{corners[n], corners[(n + 1) % 3]}];
      }
    }
    const GridPlace from = sample.grid.shape.place(struts[bar].from);
    double length = 1;
    if (struts[bar].direction == Strut::Direction::u) {
      length += kBarWidth / 2;  // Of two cells each has one end at the border.
      EXPECT_TRUE(from.i == 0 || from.i == 1);
    } else if (struts[bar].direction == Strut::Direction::v) {
      length += kBarWidth;
    }
    EXPECT_NEAR(volume, length * kBarWidth * kBarHeight, 1e-12) << bar;
  }
  for (const auto& [edge, count] : edges) {
    EXPECT_EQ(count, 1);
    EXPECT_TRUE(edges.contains({edge.second, edge.first}));
  }
}

/// On an arc, of which the cubic curve is a good likeness.
TEST(BarMesh, BarsBendBetweenTheirJoints) {
  FrameSample sample = frameSample({2, 2, 1});
  sample.positions = sample.grid.positions;
  sample.rotations = unturnedJoints(sample.grid.shape.vertexCount());
  const double angle = 0.25;  // Between the arc's chord, of length 1, and its ends.
  sample.rotations.col(0) =
      Eigen::Quaterniond(Eigen::AngleAxisd(-angle, Vector3d::UnitY())).coeffs();
  sample.rotations.col(1) =
      Eigen::Quaterniond(Eigen::AngleAxisd(angle, Vector3d::UnitY())).coeffs();
  const Eigen::Matrix3Xd vertices = barVertices(sample.grid, sample.positions, sample.rotations);
  const Vector3d middle = sectionOf(vertices, 0, kBarMeshPieces / 2).rowwise().mean();
  const double rise = std::tan(angle / 2) / 2;
  EXPECT_NEAR(middle.x(), 0.5, 1e-12);
  EXPECT_NEAR(middle.z(), rise, 0.02 * rise);
}

}  // namespace
}  // namespace morphgrid
