#include "surface/closest_point.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace morphgrid {
namespace {

TEST(ClosestPointQuery, MeasuresToFaceEdgeAndCorner) {
  Eigen::Matrix3Xd vertices(3, 3);
  vertices << 0, 1, 0,  //
      0, 0, 1,          //
      0, 0, 0;
  Eigen::Matrix3Xi triangles(3, 1);
  triangles << 0, 1, 2;
  const ClosestPointQuery query(vertices, triangles);
  EXPECT_NEAR(query.distance({0.25, 0.25, 0.5}), 0.5, 1e-12);
  EXPECT_NEAR(query.distance({0.5, -2, 0}), 2, 1e-12);
  EXPECT_NEAR(query.distance({-3, -4, 0}), 5, 1e-12);
  EXPECT_NEAR(query.distance({1, 1, 0}), std::sqrt(0.5), 1e-12);
  EXPECT_EQ(query.distance({0.2, 0.3, 0}), 0);
}

TEST(ClosestPointQuery, FindsTheNearestOfManyTriangles) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  constexpr int kTriangles = 300;
  Eigen::Matrix3Xd vertices(3, 3 * kTriangles);
  Eigen::Matrix3Xi triangles(3, kTriangles);
  for (int n = 0; n < kTriangles; ++n) {
    const Eigen::Vector3d center(coordinate(random), coordinate(random), coordinate(random));
    for (int corner = 0; corner < 3; ++corner) {
      vertices.col(3 * n + corner) =
          center +
          0.1 * Eigen::Vector3d(coordinate(random), coordinate(random), coordinate(random));
      triangles(corner, n) = 3 * n + corner;
    }
  }
  const ClosestPointQuery all(vertices, triangles);
  for (int trial = 0; trial < 20; ++trial) {
    const Eigen::Vector3d p(coordinate(random), coordinate(random), coordinate(random));
    double nearest = 1e9;
    for (int n = 0; n < kTriangles; ++n) {
      nearest = std::min(nearest, ClosestPointQuery(vertices, triangles.col(n)).distance(p));
    }
    EXPECT_NEAR(all.distance(p), nearest, 1e-12);
  }
}

/// A height field of n x n cells over the unit square.
ClosestPointQuery hills(int n) {
  Eigen::Matrix3Xd vertices(3, (n + 1) * (n + 1));
  Eigen::Matrix3Xi triangles(3, 2 * n * n);
  for (int j = 0; j <= n; ++j) {
    for (int i = 0; i <= n; ++i) {
      const double x = double(i) / n, y = double(j) / n;
      vertices.col(j * (n + 1) + i) << x, y, 0.1 * std::sin(7 * x) * std::cos(5 * y);
    }
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      const int first = j * (n + 1) + i;
      triangles.col(2 * (j * n + i)) << first, first + 1, first + n + 2;
      triangles.col(2 * (j * n + i) + 1) << first, first + n + 2, first + n + 1;
    }
  }
  return {vertices, triangles};
}

TEST(ClosestPointQuery, ManyPointsAreAsFarAsEachByItself) {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> coordinate(-0.2, 1.2);
  const ClosestPointQuery query = hills(40);
  Eigen::Matrix3Xd points(3, 3000);
  for (Eigen::Index n = 0; n < points.cols(); ++n) {
    const double height = n % 2 == 0 ? 0 : coordinate(random);  // Half of them near the surface.
    points.col(n) << coordinate(random), coordinate(random), height;
  }
  const Eigen::VectorXd distances = query.distances(points);
  for (Eigen::Index n = 0; n < points.cols(); ++n) {
    EXPECT_EQ(distances[n], query.distance(points.col(n))) << n;
  }
}

}  // namespace
}  // namespace morphgrid
