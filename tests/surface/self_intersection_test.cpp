#include "surface/self_intersection.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>

namespace morphgrid {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

/// Two triangles without a vertex in common: one in the plane z = 0, the other as given.
std::vector<int> intersectionsWith(const Eigen::Matrix3d& other,
                                   const Eigen::Affine3d& motion = Eigen::Affine3d::Identity()) {
  Eigen::Matrix3Xd vertices(3, 6);
  vertices.leftCols<3>() << 0, 1, 0, 0, 0, 1, 0, 0, 0;
  vertices.rightCols<3>() = other;
  Eigen::Matrix3Xi triangles(3, 2);
  triangles << 0, 3, 1, 4, 2, 5;
  return findSelfIntersections(motion * vertices, triangles);
}

Eigen::Matrix3d triangle(const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                         const Eigen::Vector3d& c) {
  Eigen::Matrix3d corners;
  corners << a, b, c;
  return corners;
}

TEST(SelfIntersections, OneTrianglePiercesAnother) {
  EXPECT_THAT(intersectionsWith(triangle({0.2, 0.2, -1}, {0.3, 0.2, 1}, {0.2, 0.3, 1})),
              ElementsAre(0, 1));
  EXPECT_THAT(intersectionsWith(triangle({0.2, 0.2, 0.1}, {0.3, 0.2, 1}, {0.2, 0.3, 1})),
              IsEmpty());
  EXPECT_THAT(intersectionsWith(triangle({0.6, 0.6, -1}, {0.7, 0.6, 1}, {0.6, 0.7, 1})), IsEmpty())
      << "boxes overlap, triangles do not";
}

TEST(SelfIntersections, InOnePlane) {
  EXPECT_THAT(intersectionsWith(triangle({0.1, 0.1, 0}, {0.2, 0.1, 0}, {0.1, 0.2, 0})),
              ElementsAre(0, 1));
  EXPECT_THAT(intersectionsWith(triangle({0.9, 0.9, 0}, {0.8, 0.9, 0}, {0.9, 0.8, 0})), IsEmpty());
}

TEST(SelfIntersections, FarFromTheOriginAndAtAnyScale) {
  const Eigen::Matrix3d piercing = triangle({0.2, 0.2, -1}, {0.3, 0.2, 1}, {0.2, 0.3, 1});
  const Eigen::Matrix3d above = triangle({0.2, 0.2, 1e-3}, {0.3, 0.2, 1}, {0.2, 0.3, 1});
  for (const double scale : {1e-4, 1.0, 1e5}) {
    const Eigen::Affine3d motion = Eigen::Scaling(scale) * Eigen::Translation3d(1000, -2000, 500) *
                                   Eigen::AngleAxisd(1.2, Eigen::Vector3d(1, 2, 3).normalized());
    EXPECT_THAT(intersectionsWith(piercing, motion), ElementsAre(0, 1)) << scale;
    EXPECT_THAT(intersectionsWith(above, motion), IsEmpty()) << scale;
  }
}

TEST(SelfIntersections, NeighboursDoNotCount) {
  Eigen::Matrix3Xd vertices(3, 5);
  vertices << 0, 1, 0, 0.2, 0.3, 0, 0, 1, 0.2, 0.1, 0, 0, 0, 1, -1;
  Eigen::Matrix3Xi triangles(3, 2);  // The second starts at a corner of the first and pierces it.
  triangles << 0, 0, 1, 3, 2, 4;
  EXPECT_THAT(findSelfIntersections(vertices, triangles), IsEmpty());
}

TEST(SelfIntersections, TrianglesWithoutAreaMeetNothing) {
  EXPECT_THAT(intersectionsWith(triangle({0.2, 0.2, -1}, {0.2, 0.2, 0}, {0.2, 0.2, 1})), IsEmpty());
  EXPECT_THAT(intersectionsWith(Eigen::Matrix3d::Constant(0.1)), IsEmpty());
}

/// Everything at one place must not take quadratic time, nor the answer be lost.
TEST(SelfIntersections, HeapOfTriangles) {
  constexpr int kCount = 3000;
  Eigen::Matrix3Xd vertices(3, 3 * kCount);
  Eigen::Matrix3Xi triangles(3, kCount);
  for (int n = 0; n < kCount; ++n) {
    const Eigen::Matrix3d corners = Eigen::AngleAxisd(n, Eigen::Vector3d(1, 2, 3).normalized()) *
                                    triangle({-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
    vertices.middleCols<3>(3 * n) = corners;
    triangles.col(n) << 3 * n, 3 * n + 1, 3 * n + 2;
  }
  EXPECT_EQ(findSelfIntersections(vertices, triangles).size(), std::size_t{kCount});
}

}  // namespace
}  // namespace morphgrid
