#include "surface/bezier_patch.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "core/error.h"

namespace morphgrid {
namespace {

using Eigen::Vector3d;

/// Control points at (i/3, j/3) with heights z(i, j).
template <typename Height>
BezierPatch::ControlPoints lattice(Height height) {
  BezierPatch::ControlPoints points;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      points[j][i] = Vector3d(i / 3.0, j / 3.0, height(i, j));
    }
  }
  return points;
}

BezierPatch::ControlPoints randomPoints(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> height(-0.4, 0.4);
  return lattice([&](int, int) { return height(random); });
}

TEST(BezierPatch, PlaneIsReproducedAndFlat) {
  const BezierPatch patch(lattice([](int, int) { return 2.0; }));
  for (const double u : {0.0, 0.3, 1.0}) {
    for (const double v : {0.0, 0.7, 1.0}) {
      EXPECT_LT((patch.point(u, v) - Vector3d(u, v, 2)).norm(), 1e-15);
      EXPECT_EQ(patch.curvatureAlongU(u, v), 0);
      EXPECT_EQ(patch.curvatureAlongV(u, v), 0);
      EXPECT_LT((patch.normal(u, v) - Vector3d::UnitZ()).norm(), 1e-15);
    }
  }
}

TEST(BezierPatch, ParabolaHasItsCurvature) {
  // z = u^2 has the control heights 0, 0, 1/3, 1; kappa = 2 / (1 + 4 u^2)^(3/2), towards +z.
  const double heights[] = {0, 0, 1.0 / 3, 1};
  const BezierPatch patch(lattice([&](int i, int) { return heights[i]; }));
  for (const double u : {0.0, 0.25, 0.5, 1.0}) {
    EXPECT_NEAR(patch.curvatureAlongU(u, 0.4), 2 / std::pow(1 + 4 * u * u, 1.5), 1e-12);
    EXPECT_NEAR(patch.curvatureAlongV(u, 0.4), 0, 1e-12);
  }
  const BezierPatch below(lattice([&](int i, int) { return -heights[i]; }));
  EXPECT_NEAR(below.curvatureAlongU(0, 0.5), -2, 1e-12);
}

TEST(BezierPatch, LiesInTheHullOfItsControlPoints) {
  const auto points = randomPoints(7);
  const BezierPatch patch(points);
  for (double u = 0; u <= 1; u += 0.1) {
    for (double v = 0; v <= 1; v += 0.1) {
      EXPECT_LE(std::abs(patch.point(u, v).z()), 0.4);
    }
  }
}

TEST(BezierPatch, CurvatureAgreesWithFiniteDifferences) {
  const BezierPatch patch(randomPoints(3));
  constexpr double h = 1e-4;
  for (const double u : {0.2, 0.6}) {
    for (const double v : {0.3, 0.8}) {
      const Vector3d before = patch.point(u, v - h);
      const Vector3d here = patch.point(u, v);
      const Vector3d after = patch.point(u, v + h);
      const Vector3d first = (after - before) / (2 * h);
      const Vector3d second = (after - 2 * here + before) / (h * h);
      const double sign = patch.normal(u, v).dot(second) >= 0 ? 1 : -1;
      const double expected = sign * first.cross(second).norm() / std::pow(first.norm(), 3);
      EXPECT_NEAR(patch.curvatureAlongV(u, v), expected, 1e-5);
    }
  }
}

TEST(BezierPatch, RigidMotionAndScaleActAsTheyShould) {
  const auto points = randomPoints(5);
  const Eigen::AngleAxisd rotation(1.1, Vector3d(1, 2, -0.5).normalized());
  auto moved = points;
  for (auto& row : moved) {
    for (Vector3d& p : row) {
      p = 100 * (rotation * p) + Vector3d(5, -7, 1e3);
    }
  }
  const BezierPatch patch(points);
  const BezierPatch other(moved);
  EXPECT_NEAR(100 * other.curvatureAlongU(0.3, 0.6), patch.curvatureAlongU(0.3, 0.6), 1e-9);
  EXPECT_NEAR(100 * other.curvatureAlongV(0.3, 0.6), patch.curvatureAlongV(0.3, 0.6), 1e-9);
}

TEST(BezierPatch, CollapsedEdgeStaysFinite) {
  auto points = randomPoints(11);
  for (Vector3d& p : points[0]) {
    p = Vector3d(0.5, 0, 0);
  }
  const BezierPatch patch(points);
  for (const double u : {0.0, 0.5, 1.0}) {
    EXPECT_TRUE(std::isfinite(patch.curvatureAlongU(u, 0)));
    EXPECT_TRUE(std::isfinite(patch.curvatureAlongV(u, 0)));
    EXPECT_NEAR(patch.normal(u, 0).norm(), 1, 1e-12);
  }
}

TEST(BezierPatch, CoincidentNeighboursStayFinite) {
  auto points = randomPoints(13);
  points[0][1] = points[0][0];
  points[1][0] = points[0][0];
  const BezierPatch patch(points);
  EXPECT_TRUE(std::isfinite(patch.curvatureAlongU(0, 0)));
  EXPECT_TRUE(std::isfinite(patch.curvatureAlongV(0, 0)));
  EXPECT_NEAR(patch.normal(0, 0).norm(), 1, 1e-12);
}

TEST(BezierPatch, RefusesWhatIsNoSurface) {
  auto point = lattice([](int, int) { return 0.0; });
  for (auto& row : point) {
    row.fill(Vector3d(1, 2, 3));
  }
  EXPECT_THROW(BezierPatch{point}, InputError);
  auto line = lattice([](int, int) { return 0.0; });
  for (auto& row : line) {
    for (Vector3d& p : row) {
      p.y() = 2 * p.x();
    }
  }
  EXPECT_THROW(BezierPatch{line}, InputError);
  auto broken = lattice([](int, int) { return 0.0; });
  broken[2][1].z() = std::nan("");
  EXPECT_THROW(BezierPatch{broken}, InputError);
}

}  // namespace
}  // namespace morphgrid
