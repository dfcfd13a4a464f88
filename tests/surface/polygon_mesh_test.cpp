#include "surface/polygon_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <numeric>

#include "tests/surface/mesh_files.h"

namespace morphgrid {
namespace {

PolygonMesh polygonOf(const Eigen::Matrix3Xd& points) {
  PolygonMesh polygons;
  polygons.coordinates.assign(points.data(), points.data() + points.size());
  polygons.corners.resize(points.cols());
  std::iota(polygons.corners.begin(), polygons.corners.end(), 0);
  polygons.cornerCounts = {static_cast<int>(points.cols())};
  return polygons;
}

/// Corners at 1 and `inner` from the centre in turn, in a slanted plane far from the origin.
Eigen::Matrix3Xd starOf(int corners, double inner) {
  const Eigen::Vector3d u = Eigen::Vector3d(1, 2, 2) / 3;
  const Eigen::Vector3d v = Eigen::Vector3d(2, 1, -2) / 3;
  Eigen::Matrix3Xd points(3, corners);
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * std::numbers::pi * i / corners;
    const double radius = i % 2 == 0 ? 1 : inner;
    points.col(i) =
        Eigen::Vector3d(100, 200, 300) + radius * (std::cos(angle) * u + std::sin(angle) * v);
  }
  return points;
}

double starArea(int corners, double inner) {
  return corners * inner * std::sin(2 * std::numbers::pi / corners) / 2;
}

Eigen::Vector3d normalOf(const TriangleMesh& mesh, int triangle) {
  const Eigen::Vector3i corners = mesh.triangles.col(triangle);
  const Eigen::Vector3d a = mesh.vertices.col(corners[0]);
  return (mesh.vertices.col(corners[1]) - a).cross(mesh.vertices.col(corners[2]) - a);
}

TEST(PolygonMesh, CutsPolygonsIntoTrianglesThatCoverThem) {
  for (const int corners : {4, 6, 10, 40, 200}) {
    for (const double inner : {1.0, 0.7, 0.2}) {
      if (corners == 4 && inner < 1) continue;
      const TriangleMesh mesh = triangulate(polygonOf(starOf(corners, inner)));
      ASSERT_EQ(mesh.triangles.cols(), corners - 2);
      EXPECT_NEAR(areaOf(mesh), starArea(corners, inner), 1e-10) << corners << ' ' << inner;
    }
  }
}

TEST(PolygonMesh, TrianglesFaceTheWayOfThePolygon) {
  const Eigen::Vector3d up = Eigen::Vector3d(1, 2, 2).cross(Eigen::Vector3d(2, 1, -2));
  const TriangleMesh star = triangulate(polygonOf(starOf(20, 0.3)));
  const TriangleMesh reversed = triangulate(polygonOf(starOf(20, 0.3).rowwise().reverse()));
  for (int i = 0; i < star.triangles.cols(); ++i) {
    EXPECT_GT(normalOf(star, i).dot(up), 0);
    EXPECT_LT(normalOf(reversed, i).dot(up), 0);
  }
}

TEST(PolygonMesh, CutsQuadsAlongTheShorterDiagonal) {
  Eigen::Matrix3Xd flat(3, 4);
  flat << 0, 2, 4, 2, 0, -1, 0, 1, 0, 0, 0, 0;  // 0-2 is 4 long, 1-3 is 2.
  for (int turn = 0; turn < 4; ++turn) {
    Eigen::Matrix3Xd quad(3, 4);
    for (int i = 0; i < 4; ++i) quad.col(i) = flat.col((i + turn) % 4);
    const TriangleMesh mesh = triangulate(polygonOf(quad));
    const int shortEnd = turn % 2 == 0 ? 1 : 0;
    for (const auto triangle : mesh.triangles.colwise()) {
      EXPECT_THAT(triangle, testing::Contains(shortEnd));
      EXPECT_THAT(triangle, testing::Contains(shortEnd + 2));
    }
  }
}

TEST(PolygonMesh, CutsConcaveQuadsInside) {
  Eigen::Matrix3Xd dart(3, 4);
  dart << 0, 4, 0, 1, 0, 1, 2, 1, 0, 0, 0, 0;
  EXPECT_NEAR(areaOf(triangulate(polygonOf(dart))), 3, 1e-12);
}

TEST(PolygonMesh, KeepsFlatAndCrossingPolygonsWithoutHarm) {
  EXPECT_EQ(triangulate(polygonOf(Eigen::Matrix3Xd::Zero(3, 7))).triangles.cols(), 5);
  Eigen::Matrix3Xd bow(3, 4);
  bow << 0, 1, 0, 1, 0, 1, 1, 0, 0, 0, 0, 0;
  EXPECT_EQ(triangulate(polygonOf(bow)).triangles.cols(), 2);
}

TEST(PolygonMesh, FindsTheFirstCornerOutOfRange) {
  PolygonMesh polygons{std::vector<double>(9), {0, 1, 2, 2, 1, 0, 1, 0, 1, 3}, {3, 4, 3}};
  ASSERT_TRUE(findBadCorner(polygons));
  EXPECT_EQ(findBadCorner(polygons)->polygon, 2);
  EXPECT_EQ(findBadCorner(polygons)->index, 3);
  polygons.corners[3] = -1;
  EXPECT_EQ(findBadCorner(polygons)->polygon, 1);
  polygons.corners[3] = polygons.corners[9] = 2;
  EXPECT_FALSE(findBadCorner(polygons));
}

}  // namespace
}  // namespace morphgrid
