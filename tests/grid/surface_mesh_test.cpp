#include "grid/surface_mesh.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <functional>
#include <numbers>

namespace morphgrid {
namespace {

/// Points of surface(s, t), s and t in [0, 1], u running along s.
Eigen::Matrix3Xd lattice(int countU, int countV,
                         const std::function<Eigen::Vector3d(double, double)>& surface) {
  Eigen::Matrix3Xd points(3, countU * countV);
  for (int j = 0; j < countV; ++j) {
    for (int i = 0; i < countU; ++i) {
      points.col(j * countU + i) =
          surface(static_cast<double>(i) / (countU - 1), static_cast<double>(j) / (countV - 1));
    }
  }
  return points;
}

/// A piece of the unit sphere away from the poles, normal outwards.
Eigen::Vector3d onSphere(double s, double t) {
  const double longitude = 1.2 * s;
  const double latitude = -0.6 + 1.2 * t;
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
          std::sin(latitude)};
}

Eigen::Vector3d triangleNormal(const SurfaceMesh& mesh, Eigen::Index triangle) {
  const Eigen::Vector3i corners = mesh.triangles.col(triangle);
  const Eigen::Vector3d apex = mesh.vertices.col(corners[0]);
  return Eigen::Vector3d(mesh.vertices.col(corners[1]) - apex)
      .cross(Eigen::Vector3d(mesh.vertices.col(corners[2]) - apex));
}

void expectUnitNormals(const SurfaceMesh& mesh) {
  ASSERT_EQ(mesh.normals.cols(), mesh.vertices.cols());
  for (const auto& normal : mesh.normals.colwise()) {
    EXPECT_NEAR(normal.norm(), 1, 1e-14);
  }
}

void expectTrianglesFollowNormals(const SurfaceMesh& mesh) {
  for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
    for (const int corner : mesh.triangles.col(i)) {
      EXPECT_GT(triangleNormal(mesh, i).dot(mesh.normals.col(corner)), 0) << "triangle " << i;
    }
  }
}

TEST(Tessellate, CountsVerticesAndTriangles) {
  const SurfaceMesh mesh = tessellate({5, 3, 1}, lattice(5, 3, onSphere), 4);
  EXPECT_EQ(mesh.vertices.cols(), 17 * 9);
  EXPECT_EQ(mesh.triangles.cols(), 2 * 16 * 8);
  EXPECT_EQ(mesh.triangles.minCoeff(), 0);
  EXPECT_EQ(mesh.triangles.maxCoeff(), 17 * 9 - 1);
}

TEST(Tessellate, RefineOfOneKeepsThePoints) {
  const Eigen::Matrix3Xd points = lattice(4, 6, onSphere);
  EXPECT_EQ(tessellate({4, 6, 1}, points, 1).vertices, points);
}

TEST(Tessellate, PassesThroughThePointsExactly) {
  const int countU = 4, countV = 3, refine = 5;
  const Eigen::Matrix3Xd points = lattice(countU, countV, onSphere);
  const SurfaceMesh mesh = tessellate({countU, countV, 1}, points, refine);
  const int finer = (countU - 1) * refine + 1;
  for (int j = 0; j < countV; ++j) {
    for (int i = 0; i < countU; ++i) {
      EXPECT_EQ(mesh.vertices.col(j * refine * finer + i * refine), points.col(j * countU + i));
    }
  }
}

TEST(Tessellate, UnevenPlanarLatticeStaysPlanar) {
  const Eigen::Vector3d normal = Eigen::Vector3d(1, -2, 3).normalized();
  const Eigen::Vector3d across = normal.unitOrthogonal();
  const Eigen::Vector3d along = normal.cross(across);
  const auto plane = [&](double s, double t) -> Eigen::Vector3d {
    return normal * 0.7 + across * (3 * s + 0.4 * s * t) + along * (t * t + t + 0.2 * s);
  };
  const SurfaceMesh mesh = tessellate({6, 4, 1}, lattice(6, 4, plane), 3);
  EXPECT_LT(((normal.transpose() * mesh.vertices).array() - 0.7).abs().maxCoeff(), 1e-14);
  EXPECT_LT((mesh.normals.colwise() - normal).colwise().norm().maxCoeff(), 1e-14);
  expectTrianglesFollowNormals(mesh);
}

TEST(Tessellate, TwoPointsAcrossAreJoinedStraight) {
  const Eigen::Matrix3Xd points =
      lattice(2, 2, [](double s, double t) { return Eigen::Vector3d(2 * s, 3 * t, s * t); });
  const SurfaceMesh mesh = tessellate({2, 2, 1}, points, 2);
  EXPECT_LT((mesh.vertices.col(4) - Eigen::Vector3d(1, 1.5, 0.25)).norm(), 1e-15);
}

// Central differences inside and the parabola's tangent at the ends are exact for parabolas.
TEST(Tessellate, ReproducesAParaboloidUpToItsEdges) {
  const auto height = [](double x, double y) { return x * x - 2 * y * y + x * y + y; };
  const Eigen::Matrix3Xd points =
      lattice(5, 4, [&](double s, double t) { return Eigen::Vector3d(s, t, height(s, t)); });
  const SurfaceMesh mesh = tessellate({5, 4, 1}, points, 7);
  for (Eigen::Index i = 0; i < mesh.vertices.cols(); ++i) {
    const double x = mesh.vertices(0, i), y = mesh.vertices(1, i);
    EXPECT_NEAR(mesh.vertices(2, i), height(x, y), 1e-14);
    const Eigen::Vector3d normal(-(2 * x + y), -(-4 * y + x + 1), 1);
    EXPECT_LT((mesh.normals.col(i) - normal.normalized()).norm(), 1e-13);
  }
}

struct SphereErrors {
  double radius;
  double normal;
};

SphereErrors sphereErrors(int count, int refine) {
  const SurfaceMesh mesh = tessellate({count, count, 1}, lattice(count, count, onSphere), refine);
  expectUnitNormals(mesh);
  expectTrianglesFollowNormals(mesh);
  return {(mesh.vertices.colwise().norm().array() - 1).abs().maxCoeff(),
          (mesh.normals - mesh.vertices).colwise().norm().maxCoeff()};
}

TEST(Tessellate, SphereConvergesWithTheLattice) {
  const SphereErrors coarse = sphereErrors(9, 3);
  const SphereErrors fine = sphereErrors(17, 3);
  EXPECT_LT(fine.radius, coarse.radius / 6);  // third order: 8 in the limit
  EXPECT_LT(fine.normal, coarse.normal / 3);  // second order: 4
  EXPECT_LT(fine.radius, 1e-4);
}

TEST(Tessellate, SphereAreaConvergesWithRefinement) {
  const double area = 1.2 * 2 * std::sin(0.6);
  const auto areaError = [&](int refine) {
    const SurfaceMesh mesh = tessellate({9, 9, 1}, lattice(9, 9, onSphere), refine);
    double sum = 0;
    for (Eigen::Index i = 0; i < mesh.triangles.cols(); ++i) {
      sum += triangleNormal(mesh, i).norm() / 2;
    }
    return std::abs(sum - area) / area;
  };
  EXPECT_LT(areaError(4), areaError(1) / 10);
}

TEST(Tessellate, PoleGetsTheNormalOfItsSurroundings) {
  const auto cap = [](double s, double t) -> Eigen::Vector3d {
    const double longitude = 2 * std::numbers::pi * s;
    const double latitude = std::numbers::pi * (t - 0.5);
    return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
            std::sin(latitude)};
  };
  const SurfaceMesh mesh = tessellate({25, 13, 1}, lattice(25, 13, cap), 2);
  expectUnitNormals(mesh);
  EXPECT_GT((mesh.normals.array() * mesh.vertices.array()).colwise().sum().minCoeff(), 0.98);
}

TEST(Tessellate, CollapsedLatticesHaveFiniteNormals) {
  const Eigen::Matrix3Xd point = Eigen::Vector3d(1, 2, 3).replicate(1, 12);
  expectUnitNormals(tessellate({4, 3, 1}, point, 2));
  const Eigen::Matrix3Xd line =
      lattice(4, 3, [](double s, double t) { return Eigen::Vector3d(s + t, 2 * s + 2 * t, 0); });
  expectUnitNormals(tessellate({4, 3, 1}, line, 2));
}

TEST(Tessellate, NormalsDoNotDependOnTheUnit) {
  const Eigen::Matrix3Xd points = lattice(5, 4, onSphere);
  const Eigen::Matrix3Xd normals = tessellate({5, 4, 1}, points, 2).normals;
  for (const double unit : {1e-100, 1e-6, 1e6, 1e100}) {
    EXPECT_LT((tessellate({5, 4, 1}, points * unit, 2).normals - normals).norm(), 1e-12) << unit;
  }
}

}  // namespace
}  // namespace morphgrid
