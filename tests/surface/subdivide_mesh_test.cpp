#include "surface/subdivide_mesh.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>
#include <utility>

#include "core/error.h"

namespace morphgrid {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

TriangleMesh meshOf(const std::vector<Vector3d>& vertices, const std::vector<Vector3i>& triangles) {
  TriangleMesh mesh{Eigen::Matrix3Xd(3, vertices.size()), Eigen::Matrix3Xi(3, triangles.size())};
  for (std::size_t n = 0; n < vertices.size(); ++n)
    mesh.vertices.col(Eigen::Index(n)) = vertices[n];
  for (std::size_t n = 0; n < triangles.size(); ++n) {
    mesh.triangles.col(Eigen::Index(n)) = triangles[n];
  }
  return mesh;
}

/// Corners at distance sqrt(1 + phi^2) from the origin.
TriangleMesh icosahedron() {
  constexpr double a = 1;
  constexpr double b = std::numbers::phi;
  return meshOf(
      {{-a, b, 0},
       {a, b, 0},
       {-a, -b, 0},
       {a, -b, 0},
       {0, -a, b},
       {0, a, b},
       {0, -a, -b},
       {0, a, -b},
       {b, 0, -a},
       {b, 0, a},
       {-b, 0, -a},
       {-b, 0, a}},
      {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
       {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
       {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}});
}

/// A square of side n in the plane z = 2 with 2 n^2 triangles.
TriangleMesh flatSquare(int n) {
  std::vector<Vector3d> vertices;
  std::vector<Vector3i> triangles;
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) vertices.emplace_back(i, j, 2);
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int corner = j * (n + 1) + i;
      triangles.emplace_back(corner, corner + 1, corner + n + 2);
      triangles.emplace_back(corner, corner + n + 2, corner + n + 1);
    }
  }
  return meshOf(vertices, triangles);
}

/// Every triangle with vertices of its own, as in STL files.
TriangleMesh unshared(const TriangleMesh& mesh) {
  TriangleMesh soup{mesh.vertices(Eigen::all, mesh.triangles.reshaped()),
                    Eigen::Matrix3Xi(3, mesh.triangles.cols())};
  for (int n = 0; n < soup.triangles.size(); ++n) soup.triangles.reshaped()[n] = n;
  return soup;
}

/// How often the triangles walk each edge, per direction.
std::map<std::pair<int, int>, int> countDirectedEdges(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> counts;
  for (const auto& triangle : mesh.triangles.colwise()) {
    for (int corner = 0; corner < 3; ++corner) {
      ++counts[{triangle[corner], triangle[(corner + 1) % 3]}];
    }
  }
  return counts;
}

/// Edges of one triangle; -1 when neighbours disagree about a direction.
int countBoundaryEdges(const TriangleMesh& mesh) {
  const auto counts = countDirectedEdges(mesh);
  int boundary = 0;
  for (const auto& [edge, count] : counts) {
    if (count != 1) return -1;
    if (!counts.contains({edge.second, edge.first})) ++boundary;
  }
  return boundary;
}

double signedVolume(const TriangleMesh& mesh) {
  double volume = 0;
  for (const auto& t : mesh.triangles.colwise()) {
    volume += mesh.vertices.col(t[0]).dot(
                  Vector3d(mesh.vertices.col(t[1])).cross(Vector3d(mesh.vertices.col(t[2])))) /
              6;
  }
  return volume;
}

std::string errorOf(const TriangleMesh& mesh, int rounds) {
  try {
    subdivideLoop(mesh, rounds);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

/// Largest angle between the normals of neighbouring triangles, in radians.
double sharpestCrease(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, Vector3d> normals;
  for (const auto& t : mesh.triangles.colwise()) {
    const Vector3d a = mesh.vertices.col(t[0]);
    const Vector3d normal = (Vector3d(mesh.vertices.col(t[1])) - a)
                                .cross(Vector3d(mesh.vertices.col(t[2])) - a)
                                .normalized();
    for (int corner = 0; corner < 3; ++corner) normals[{t[corner], t[(corner + 1) % 3]}] = normal;
  }
  double sharpest = 0;
  for (const auto& [edge, normal] : normals) {
    const Vector3d& other = normals.at({edge.second, edge.first});
    sharpest = std::max(sharpest, std::acos(std::min(1.0, normal.dot(other))));
  }
  return sharpest;
}

TEST(SubdivideLoop, NoRoundsLeaveTheMeshAsItIs) {
  const TriangleMesh soup = unshared(icosahedron());
  const TriangleMesh same = subdivideLoop(soup, 0).mesh;
  EXPECT_EQ(same.vertices, soup.vertices);
  EXPECT_EQ(same.triangles, soup.triangles);
}

TEST(SubdivideLoop, AClosedBodyStaysClosedAndBecomesSmooth) {
  double crease = sharpestCrease(icosahedron());
  for (int rounds = 1; rounds <= 4; ++rounds) {
    SCOPED_TRACE(rounds);
    const TriangleMesh mesh = subdivideLoop(icosahedron(), rounds).mesh;
    const int factor = 1 << (2 * rounds);
    EXPECT_EQ(mesh.triangles.cols(), 20 * factor);
    EXPECT_EQ(mesh.vertices.cols(), 10 * factor + 2);  // V - E + F = 2, 2 E = 3 F.
    EXPECT_EQ(countBoundaryEdges(mesh), 0);
    EXPECT_GT(signedVolume(mesh), 0);
    EXPECT_LT(sharpestCrease(mesh), 0.7 * crease);
    crease = sharpestCrease(mesh);
  }
}

TEST(SubdivideLoop, VerticesMoveByLoopsWeights) {
  // At valence 5 a vertex keeps 1 - 5 beta, with beta = (5/8 - (3/8 + cos(2 pi / 5) / 4)^2) / 5; an
  // edge's middle weighs its ends by 3/8, the corners beside it by 1/8. By symmetry both kinds lie
  // on spheres.
  constexpr double pi = std::numbers::pi;
  const double radius = std::sqrt(1 + std::numbers::phi * std::numbers::phi);
  const double fiveBeta = 5.0 / 8 - std::pow(3.0 / 8 + std::cos(2 * pi / 5) / 4, 2);
  const double neighbours = radius / std::sqrt(5);  // Height of the ring's plane.
  const double corner = (1 - fiveBeta) * radius + fiveBeta * neighbours;
  const Vector3d a(-1, std::numbers::phi, 0), b(1, std::numbers::phi, 0);
  const Vector3d left(0, 1, std::numbers::phi), right(0, 1, -std::numbers::phi);
  const double middle = ((a + b) * 3 / 8 + (left + right) / 8).norm();

  const TriangleMesh mesh = subdivideLoop(icosahedron(), 1).mesh;
  std::vector<double> distances;
  for (const auto& p : mesh.vertices.colwise()) distances.push_back(p.norm());
  const auto near = [&](double distance) {
    return std::count_if(distances.begin(), distances.end(),
                         [&](double d) { return std::abs(d - distance) < 1e-12; });
  };
  EXPECT_EQ(near(corner), 12);
  EXPECT_EQ(near(middle), 30);
}

TEST(SubdivideLoop, AFlatPatchStaysFlatAndKeepsItsBoundary) {
  const TriangleMesh mesh = subdivideLoop(flatSquare(4), 2).mesh;
  EXPECT_EQ(mesh.triangles.cols(), 2 * 16 * 16);
  EXPECT_EQ(countBoundaryEdges(mesh), 4 * 16);
  EXPECT_TRUE((mesh.vertices.row(2).array() == 2).all());
  // Straight sides stay where they are; only the corners are rounded.
  const Eigen::AlignedBox3d box = boundingBox(mesh);
  EXPECT_LT((box.min() - Vector3d(0, 0, 2)).norm(), 1e-12);
  EXPECT_LT((box.max() - Vector3d(4, 4, 2)).norm(), 1e-12);
}

TEST(SubdivideLoop, JoinsVerticesAtTheSamePlace) {
  const TriangleMesh joined = subdivideLoop(unshared(icosahedron()), 2).mesh;
  EXPECT_EQ(joined.vertices.cols(), 10 * 16 + 2);
  EXPECT_EQ(countBoundaryEdges(joined), 0);
  EXPECT_NEAR(signedVolume(joined), signedVolume(subdivideLoop(icosahedron(), 2).mesh), 1e-12);
}

TEST(SubdivideLoop, TurnsTrianglesToAgree) {
  TriangleMesh mixed = icosahedron();
  for (int n = 1; n < 20; n += 3) mixed.triangles.col(n).reverseInPlace();
  const TriangleMesh mesh = subdivideLoop(mixed, 1).mesh;
  EXPECT_EQ(countBoundaryEdges(mesh), 0);
  EXPECT_NEAR(signedVolume(mesh), signedVolume(subdivideLoop(icosahedron(), 1).mesh), 1e-12);
}

TEST(SubdivideLoop, DropsTrianglesWithoutThreeCornersAndCopies) {
  TriangleMesh mesh = icosahedron();
  mesh.triangles.conservativeResize(3, 22);
  mesh.triangles.col(20) << 3, 3, 7;
  mesh.triangles.col(21) << 11, 5, 0;
  EXPECT_EQ(subdivideLoop(mesh, 1).mesh.triangles.cols(), 80);
  mesh.triangles = Eigen::Matrix3Xi::Constant(3, 2, 1);
  EXPECT_THAT(errorOf(mesh, 1), testing::HasSubstr("three different corners, got none"));
}

TEST(SubdivideLoop, SheetsThatTouchInAPointStayApart) {
  const TriangleMesh mesh =
      meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, -1, 0}}, {{0, 1, 2}, {0, 3, 4}});
  EXPECT_EQ(subdivideLoop(mesh, 1).mesh.vertices.cols(), 12);
}

/// A modeller writes the border of two halves twice, rounded differently.
TEST(SubdivideLoop, JoinsVerticesThatDifferByRounding) {
  TriangleMesh soup = unshared(flatSquare(4));
  for (Eigen::Index i = 0; i < soup.vertices.cols(); ++i) {
    soup.vertices.col(i).array() += (i % 3 - 1) * 1e-10;
  }
  const TriangleMesh joined = subdivideLoop(soup, 1).mesh;
  EXPECT_EQ(joined.vertices.cols(), subdivideLoop(flatSquare(4), 1).mesh.vertices.cols());
  EXPECT_EQ(countBoundaryEdges(joined), 4 * 8);
  // Farther off, in units of the extent 4, they are gaps.
  soup.vertices.col(0).x() += 1e-7;
  EXPECT_GT(countBoundaryEdges(subdivideLoop(soup, 1).mesh), 4 * 8);
}

TEST(SubdivideLoop, JoinsVerticesAlikeNearAndFar) {
  for (const double far : {0., 5e6}) {
    TriangleMesh soup = unshared(icosahedron());
    soup.vertices.array() += far;
    EXPECT_EQ(subdivideLoop(soup, 1).mesh.vertices.cols(), 42) << far;
  }
}

/// A fin on one inner edge: the sheet below it stays whole.
TEST(SubdivideLoop, CutsFinsOff) {
  TriangleMesh fin = flatSquare(4);
  fin.vertices.conservativeResize(3, 27);
  fin.vertices.col(25) << 1, 1, 3;
  fin.vertices.col(26) << 2, 1, 3;
  fin.triangles.conservativeResize(3, 34);
  fin.triangles.col(32) << 6, 7, 25;
  fin.triangles.col(33) << 7, 26, 25;
  const NotedMesh subdivided = subdivideLoop(fin, 1);
  EXPECT_THAT(subdivided.notices,
              testing::ElementsAre("cut open before Loop subdivision along 1 edge of more than two "
                                   "triangles, the first from [1, 1, 2] to [2, 1, 2]"));
  EXPECT_EQ(subdivided.mesh.triangles.cols(), 4 * 34);
  EXPECT_EQ(countBoundaryEdges(subdivided.mesh), 4 * 8 + 2 * 4);
  EXPECT_TRUE(subdivideLoop(flatSquare(4), 1).notices.empty());
}

/// Of the triangles in the plane z = 2.
double flatArea(const TriangleMesh& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles.colwise()) {
    const Eigen::Matrix3d corners = mesh.vertices(Eigen::all, t);
    if ((corners.row(2).array() != 2).any()) continue;
    area += (corners.col(1) - corners.col(0)).cross(corners.col(2) - corners.col(0)).z() / 2;
  }
  return area;
}

/// A fin on several edges in a row slits the sheet below it: both sides become the same curve.
TEST(SubdivideLoop, LeavesNoGapBelowAFin) {
  TriangleMesh fin = flatSquare(6);
  fin.vertices.conservativeResize(3, 50);
  fin.vertices.col(49) << 3, 3, 5;
  fin.triangles.conservativeResize(3, 75);
  fin.triangles.col(72) << 22, 23, 49;
  fin.triangles.col(73) << 23, 24, 49;
  fin.triangles.col(74) << 24, 25, 49;
  const NotedMesh subdivided = subdivideLoop(fin, 2);
  EXPECT_THAT(subdivided.notices, testing::ElementsAre(testing::HasSubstr("along 3 edges")));
  EXPECT_NEAR(flatArea(subdivided.mesh), flatArea(subdivideLoop(flatSquare(6), 2).mesh), 1e-12);
}

TEST(SubdivideLoop, CutsWhereSheetsCross) {
  const TriangleMesh fan = meshOf({{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0.5, 0, 1}},
                                  {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}});
  const NotedMesh subdivided = subdivideLoop(fan, 2);
  EXPECT_EQ(subdivided.mesh.triangles.cols(), 3 * 16);
  EXPECT_EQ(subdivided.notices.size(), 1);
}

TEST(SubdivideLoop, RejectsWhatHasOneSide) {
  // Moebius' strip of five triangles on five vertices.
  const TriangleMesh strip =
      meshOf({{1, 0, 0}, {0.3, 0.9, 0.5}, {-0.8, 0.6, 0}, {-0.8, -0.6, 0.5}, {0.3, -0.9, 0}},
             {{0, 1, 2}, {1, 2, 3}, {2, 3, 4}, {3, 4, 0}, {4, 0, 1}});
  EXPECT_THAT(errorOf(strip, 1), testing::HasSubstr("cannot be oriented"));
}

TEST(SubdivideLoop, RejectsWhatOverflows) {
  TriangleMesh mesh = icosahedron();
  mesh.vertices *= 1e308;
  EXPECT_THAT(errorOf(mesh, 1), testing::HasSubstr("overflows"));
}

TEST(SubdivideLoop, RejectsTooManyTrianglesBeforeItMakesThem) {
  // 20 * 4^10 is above the limit, 4^1000 beyond all numbers.
  for (const int rounds : {10, 1000}) {
    EXPECT_EQ(errorOf(icosahedron(), rounds),
              std::to_string(rounds) +
                  " rounds of Loop subdivision make too many triangles: at most 10000000 are "
                  "possible");
  }
}

}  // namespace
}  // namespace morphgrid
