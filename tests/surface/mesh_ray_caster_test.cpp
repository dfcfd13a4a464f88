#include "surface/mesh_ray_caster.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "tests/surface/sample_hits.h"
#include "tests/surface/sample_meshes.h"

namespace morphgrid {
namespace {

constexpr SamplingBox kUnitBox{-1, -1, 2, 2};

double tilted(double y, double z) { return 2 + 0.3 * y - 1.7 * z; }

TEST(MeshRayCaster, RunsTheFirstAndLastRaysAlongTheBoxsEdges) {
  const SamplingBox box{-0.3, 0.1, 0.7, 0.4};
  const RayHits hits = MeshRayCaster(heightField(kUnitBox, 3, 3, tilted)).cast(box, 8, 5);
  ASSERT_EQ(hits.points.cols(), 40);
  ASSERT_EQ(hits.hit.size(), 40U);
  EXPECT_EQ(hits.points(1, hits.index(0, 0)), -0.3);
  EXPECT_EQ(hits.points(2, hits.index(0, 0)), 0.1);
  EXPECT_EQ(hits.points(1, hits.index(7, 4)), -0.3 + 0.7);
  EXPECT_EQ(hits.points(2, hits.index(7, 4)), 0.1 + 0.4);
  EXPECT_NEAR(hits.points(1, hits.index(3, 2)), 0.0, 1e-15);
  EXPECT_NEAR(hits.points(2, hits.index(3, 2)), 0.3, 1e-15);
  EXPECT_NEAR(hits.uStep(), 0.1, 1e-15);
  EXPECT_NEAR(hits.vStep(), 0.1, 1e-15);
}

TEST(MeshRayCaster, MeetsATiltedPlaneExactly) {
  const SamplingBox box{-1.3, 0.2, 3.1, 1.7};
  const MeshRayCaster caster(heightField(box, 7, 11, tilted));
  for (const int count : {2, 8, 12, 77, 100}) {
    const RayHits hits = caster.cast(box, count, count + 1);
    EXPECT_EQ(countMisses(hits), 0) << count;
    for (const auto& point : hits.points.colwise()) {
      EXPECT_NEAR(point.x(), tilted(point.y(), point.z()), 1e-12);
    }
  }
}

TEST(MeshRayCaster, MeetsASphereWithinItsTessellation) {
  constexpr double kRadius = 2;
  constexpr int kParallels = 200;
  const RayHits hits = MeshRayCaster(sphere(kRadius, 2 * kParallels, kParallels))
                           .cast({-1.2, -1.2, 2.4, 2.4}, 61, 61);
  // A facet is no deeper than the sagitta of its diagonal; rays meet the sphere 58 degrees askew at
  // most.
  const double diagonal = std::sqrt(2) * kRadius * std::numbers::pi / kParallels;
  const double bound = diagonal * diagonal / (8 * kRadius) / std::sqrt(1 - 2 * 0.36);
  EXPECT_EQ(countMisses(hits), 0);
  for (const auto& p : hits.points.colwise()) {
    const double exact = -std::sqrt(kRadius * kRadius - p.tail<2>().squaredNorm());
    EXPECT_GE(p.x(), exact - 1e-12);
    EXPECT_LE(p.x(), exact + bound);
  }
}

TEST(MeshRayCaster, TakesTheFirstSheetThatARayMeets) {
  const auto sheet = [](double x) {
    return heightField(kUnitBox, 1, 1, [=](double, double) { return x; });
  };
  for (const MeshRayCaster& caster :
       {MeshRayCaster(joined(sheet(3), sheet(-5))), MeshRayCaster(joined(sheet(-5), sheet(3)))}) {
    const RayHits hits = caster.cast(kUnitBox, 5, 5);
    EXPECT_EQ(hits.points.row(0).minCoeff(), -5);
    EXPECT_EQ(hits.points.row(0).maxCoeff(), -5);
  }
}

TEST(MeshRayCaster, MeetsAllEdgesOfASheetInFrontOfAnother) {
  const TriangleMesh front = heightField(kUnitBox, 16, 16, tilted);
  const TriangleMesh back = heightField({-2, -2, 4, 4}, 16, 16, [](double, double) { return 10; });
  const RayHits hits = MeshRayCaster(joined(front, back)).cast(kUnitBox, 17, 17);
  for (const auto& point : hits.points.colwise()) {
    EXPECT_NEAR(point.x(), tilted(point.y(), point.z()), 1e-12);
  }
}

/// The nearest hit of a ray along +x, by the signs of areas; infinite when there is none.
double firstOfAll(const TriangleMesh& mesh, const Eigen::Vector2d& place) {
  double first = std::numeric_limits<double>::infinity();
  for (const auto& triangle : mesh.triangles.colwise()) {
    const Eigen::Matrix3d corners = mesh.vertices(Eigen::all, triangle);
    Eigen::Matrix3d system;
    system << corners.bottomRows<2>(), Eigen::RowVector3d::Ones();
    const Eigen::Vector3d weights =
        system.fullPivLu().solve(Eigen::Vector3d(place.x(), place.y(), 1));
    if (weights.minCoeff() >= 0) {
      first = std::min(first, corners.row(0).dot(weights));
    }
  }
  return first;
}

TEST(MeshRayCaster, AgreesWithASearchOfAllTriangles) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> coordinate(-1, 1);
  constexpr int kTriangles = 200;
  TriangleMesh mesh{
      Eigen::Matrix3Xd::NullaryExpr(3, 3 * kTriangles, [&]() { return coordinate(random); }),
      Eigen::Matrix3Xi(3, kTriangles)};
  for (int n = 0; n < kTriangles; ++n) {
    mesh.triangles.col(n) << 3 * n, 3 * n + 1, 3 * n + 2;
    for (int corner : {1, 2}) {
      mesh.vertices.col(3 * n + corner) =
          mesh.vertices.col(3 * n) + 0.2 * mesh.vertices.col(3 * n + corner);
    }
  }
  const Eigen::Matrix2Xd places =
      Eigen::Matrix2Xd::NullaryExpr(2, 501, [&]() { return coordinate(random); });
  const Eigen::Matrix3Xd points = MeshRayCaster(mesh).castThrough(places);
  for (Eigen::Index n = 0; n < places.cols(); ++n) {
    const double expected = firstOfAll(mesh, places.col(n));
    EXPECT_EQ(points.col(n).tail<2>(), places.col(n));
    if (std::isinf(expected)) {
      EXPECT_TRUE(std::isnan(points(0, n))) << n;
    } else {
      EXPECT_NEAR(points(0, n), expected, 1e-12) << n;
    }
  }
}

TEST(MeshRayCaster, MissesBesideTheMesh) {
  const MeshRayCaster caster(heightField(kUnitBox, 2, 2, tilted));
  const double none = std::numeric_limits<double>::quiet_NaN();
  const double far = std::numeric_limits<double>::max();
  Eigen::Matrix2Xd places(2, 7);
  places << 1.0001, 0, far, -far, none, 0, 0,  //
      0, -1.0001, 0, far, 0, none, 0;
  const Eigen::Matrix3Xd points = caster.castThrough(places);
  for (int n = 0; n < 6; ++n) {
    EXPECT_TRUE(std::isnan(points(0, n))) << n;
  }
  EXPECT_NEAR(points(0, 6), 2, 1e-12);
  const RayHits hits = caster.cast({0, 0, 4, 0.5}, 5, 2);
  EXPECT_EQ(countMisses(hits), 6);
  EXPECT_EQ(hits.points.col(4), Eigen::Vector3d(0, 4, 0));
  EXPECT_TRUE(caster.castThrough(Eigen::Matrix2Xd(2, 0)).cols() == 0);
}

// --- No ray is lost on an edge or at a vertex.

struct Placement {
  double scale;
  Eigen::Vector3d offset;
};

class SymmetricMesh : public testing::TestWithParam<Placement> {
 protected:
  /// Moves and scales the mesh and the unit box alike, and casts odd counts: the middle rays run
  /// through the centre lines.
  void expectAllHit(const TriangleMesh& mesh, double halfBox) const {
    const auto& [scale, offset] = GetParam();
    const MeshRayCaster caster(
        transformed(Eigen::Translation3d(offset) * Eigen::Scaling(scale), mesh));
    const double half = halfBox * scale;
    const SamplingBox box{offset.y() - half, offset.z() - half, 2 * half, 2 * half};
    for (int count = 3; count < 130; count += count < 21 ? 2 : 18) {
      EXPECT_EQ(countMisses(caster.cast(box, count, count)), 0) << count << " x " << count;
    }
    EXPECT_EQ(countMisses(caster.cast(box, 1001, 3)), 0);
    EXPECT_EQ(countMisses(caster.cast(box, 3, 1001)), 0);
  }
};

TEST_P(SymmetricMesh, GableRoofLosesNoRay) {
  const auto roof = [](double, double z) { return std::abs(z); };
  expectAllHit(heightField(kUnitBox, 1, 2, roof), 1);
  expectAllHit(heightField(kUnitBox, 10, 6, roof), 1);
  expectAllHit(heightField(kUnitBox, 2, 1, [](double y, double) { return -std::abs(y); }), 1);
}

TEST_P(SymmetricMesh, PyramidFanLosesNoRay) {
  const double inside = std::sqrt(0.5);
  for (const double height : {0.0, 0.5, -3.0, 100.0}) {
    expectAllHit(pyramidFan(4, height), inside * inside);  // The box touches the rim.
    expectAllHit(pyramidFan(8, height), 0.65);
    expectAllHit(pyramidFan(360, height), inside - 1e-4);
  }
}

TEST_P(SymmetricMesh, SphereLosesNoRayAtPoleOrSeam) {
  expectAllHit(sphere(1, 16, 8), 0.6);
  expectAllHit(sphere(1, 200, 100), 0.7);
  Eigen::Affine3d upright(Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitY()));
  expectAllHit(transformed(upright, sphere(1, 200, 100)), 0.7);
}

INSTANTIATE_TEST_SUITE_P(AtManyScales, SymmetricMesh,
                         testing::Values(Placement{1, {0, 0, 0}}, Placement{1e-6, {0, 0, 0}},
                                         Placement{1e6, {0, 0, 0}}, Placement{1, {1e6, -2e6, 3e6}},
                                         Placement{0.3, {0.1, 0.7, -12.3}}));

// --- The mesh's boundary.

TEST(MeshRayCaster, HitsOnTheBoundaryAtAnyAngle) {
  for (double degrees = 0; degrees < 360; degrees += 7) {
    const Eigen::Affine3d turn(
        Eigen::AngleAxisd(degrees * std::numbers::pi / 180, Eigen::Vector3d::UnitX()));
    const MeshRayCaster caster(transformed(turn, heightField(kUnitBox, 1, 1, tilted)));
    Eigen::Matrix3Xd boundary(3, 404);
    for (int n = 0; n < 101; ++n) {
      const double along = -1 + 0.02 * n;
      for (int side = 0; side < 2; ++side) {
        const double across = 2 * side - 1;
        boundary.col(4 * n + side) << tilted(along, across), along, across;
        boundary.col(4 * n + 2 + side) << tilted(across, along), across, along;
      }
    }
    boundary = turn * boundary;
    const Eigen::Matrix3Xd points = caster.castThrough(boundary.bottomRows<2>());
    EXPECT_TRUE(points.isApprox(boundary, 1e-12)) << degrees;
    const Eigen::Matrix2Xd beside = (1 + 1e-4) * boundary.bottomRows<2>();
    EXPECT_TRUE(caster.castThrough(beside).row(0).array().isNaN().all()) << degrees;
  }
}

TEST(MeshRayCaster, ExtrapolatesThePlaneWhereARayPassesAHairBesideTheMesh) {
  const MeshRayCaster caster(heightField(kUnitBox, 4, 4, tilted));
  Eigen::Matrix2Xd places(2, 4);
  places << 1 + 1e-6, 0.3, -1 - 1e-6, 1 + 1e-6,  //
      0.25, -1 - 1e-6, 0, 1 + 1e-6;
  const Eigen::Matrix3Xd points = caster.castThrough(places);
  for (const auto& point : points.colwise()) {
    EXPECT_NEAR(point.x(), tilted(point.y(), point.z()), 1e-12);
  }
}

// --- Odd meshes.

TEST(MeshRayCaster, KeepsDoublePrecisionFarFromTheOrigin) {
  const SamplingBox box{1e6, -2e6, 1, 1};
  const auto wave = [](double y, double z) { return 3e6 + std::sin(3 * (y - 1e6)) * (z + 2e6); };
  const auto near = [](double y, double z) { return std::sin(3 * y) * z; };
  const RayHits far = MeshRayCaster(heightField(box, 64, 64, wave)).cast(box, 65, 65);
  const RayHits home =
      MeshRayCaster(heightField({0, 0, 1, 1}, 64, 64, near)).cast({0, 0, 1, 1}, 65, 65);
  EXPECT_EQ(countMisses(far), 0);
  EXPECT_LE(((far.points.row(0).array() - 3e6) - home.points.row(0).array()).abs().maxCoeff(),
            2e-9);
}

TEST(MeshRayCaster, ScalesWithTheMesh) {
  const TriangleMesh mesh = sphere(1, 60, 30);
  const RayHits expected = MeshRayCaster(mesh).cast({-0.5, -0.5, 1, 1}, 33, 33);
  for (const double scale : {1e-30, 1e-6, 1e6, 1e30}) {
    const RayHits hits = MeshRayCaster(transformed(Eigen::Affine3d(Eigen::Scaling(scale)), mesh))
                             .cast({-0.5 * scale, -0.5 * scale, scale, scale}, 33, 33);
    EXPECT_EQ(countMisses(hits), 0) << scale;
    EXPECT_LE((hits.points / scale - expected.points).cwiseAbs().maxCoeff(), 1e-12) << scale;
  }
}

TEST(MeshRayCaster, SeesPastTrianglesWithoutArea) {
  TriangleMesh odd{Eigen::Matrix3Xd(3, 6), Eigen::Matrix3Xi(3, 4)};
  odd.vertices << -9, -9, -9, -9, -8, -7,  //
      -1, 1, 0, 0, 0, 0,                   //
      0, 0, 0, -1, 1, 0;
  odd.triangles << 0, 0, 2, 3,  // A line, a line, a point, a triangle seen edge-on.
      1, 1, 2, 4,               //
      2, 1, 2, 5;
  const MeshRayCaster caster(joined(odd, heightField(kUnitBox, 2, 2, tilted)));
  const RayHits hits = caster.cast(kUnitBox, 21, 21);
  EXPECT_EQ(countMisses(hits), 0);
  for (const auto& point : hits.points.colwise()) {
    const bool edgeOn = point.y() == 0;  // There a hit on the edge would do too.
    EXPECT_TRUE(edgeOn || std::abs(point.x() - tilted(point.y(), point.z())) < 1e-12);
    EXPECT_TRUE(point.x() >= -9 && point.x() <= 4);
  }
  EXPECT_EQ(countMisses(MeshRayCaster(odd).cast({-2, -2, 3.9, 3.9}, 10, 10)), 100);
}

TEST(MeshRayCaster, AnswersForAMeshThatIsOnePoint) {
  const TriangleMesh point{Eigen::Matrix3Xd::Constant(3, 3, 0.5), Eigen::Vector3i(0, 1, 2)};
  const RayHits hits = MeshRayCaster(point).cast({0, 0, 1, 1}, 3, 3);
  for (const auto& x : hits.points.row(0)) {
    EXPECT_TRUE(x == 0 || x == 0.5);
  }
}

TEST(MeshRayCaster, TakesManyCoincidentTriangles) {
  TriangleMesh mesh = heightField(kUnitBox, 1, 1, tilted);
  mesh.triangles = mesh.triangles.replicate(1, 20000).eval();
  const RayHits hits = MeshRayCaster(mesh).cast(kUnitBox, 11, 11);
  EXPECT_EQ(countMisses(hits), 0);
  for (const auto& point : hits.points.colwise()) {
    EXPECT_NEAR(point.x(), tilted(point.y(), point.z()), 1e-12);
  }
}

TEST(MeshRayCaster, StaysWithinATriangleThatIsAlmostEdgeOn) {
  constexpr double kWidth = 1e-8;  // A step of single precision: rays beside it hit it too.
  const TriangleMesh wall = heightField({0.1, -0.5, kWidth, 1}, 1, 1,
                                        [](double y, double) { return (y - 0.1) / kWidth; });
  const TriangleMesh back = heightField(kUnitBox, 2, 2, [](double, double) { return 5; });
  const RayHits hits = MeshRayCaster(joined(wall, back)).cast({0.1 - 3e-8, -0.4, 7e-8, 0.8}, 71, 5);
  const auto x = hits.points.row(0).array();
  EXPECT_GE(x.minCoeff(), -1e-5);
  EXPECT_TRUE((x < 1 + 1e-5 || x == 5).all());
  EXPECT_TRUE((x < 1 + 1e-5).any());
}

TEST(MeshRayCaster, IgnoresVerticesThatNoTriangleUses) {
  TriangleMesh mesh = heightField(kUnitBox, 2, 2, tilted);
  mesh.vertices.conservativeResize(3, mesh.vertices.cols() + 1);
  mesh.vertices.rightCols<1>() << 1e12, 1e12, -1e12;
  const RayHits hits = MeshRayCaster(mesh).cast(kUnitBox, 9, 9);
  EXPECT_EQ(countMisses(hits), 0);
  EXPECT_NEAR(hits.points(0, hits.index(8, 8)), tilted(1, 1), 1e-12);
}

}  // namespace
}  // namespace morphgrid
