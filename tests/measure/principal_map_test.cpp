#include "measure/principal_map.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "measure/conformal_map.h"
#include "tests/measure/sample_lattices.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector2d;
using Eigen::Vector3d;

template <typename Normal>
Matrix3Xd normalsOf(const PointLattice& lattice, const Normal& normal) {
  Matrix3Xd normals(3, lattice.points.cols());
  for (int point = 0; point < normals.cols(); ++point) {
    const Vector2d parameters = parametersOf(lattice, point);
    normals.col(point) = normal(parameters.x(), parameters.y()).normalized();
  }
  return normals;
}

/// A cone's mantle: u runs along its lines, v around. Both are lines of curvature.
constexpr double kSlope = 0.6;
Vector3d cone(double u, double v) {
  const double radius = 1 + u;
  return {radius * std::cos(v), radius * std::sin(v), kSlope * radius};
}
Vector3d normalOfCone(double, double v) {
  return Vector3d(-kSlope * std::cos(v), -kSlope * std::sin(v), 1);
}

// So every circle is a line of its own u, every generator one of its own v: as the conformal map of
// the cone's developed sector has it.
TEST(PrincipalMap, KeepsToIsolinesThatAreLinesOfCurvature) {
  const PointLattice lattice = latticeOn(cone, 41, 31);
  const LatticeMap map = mapAlongCurvature(lattice, normalsOf(lattice, normalOfCone));
  const LatticeMap conformal = mapConformally(lattice);
  EXPECT_LT((map.values - conformal.values).cwiseAbs().maxCoeff(), 1e-3);
  EXPECT_NEAR(map.modulus / conformal.modulus, 1, 1e-3);
}

// A plane has no principal directions that count.
TEST(PrincipalMap, OfAPlaneIsConformal) {
  const auto skewed = [](double u, double v) { return Vector3d(u + 0.4 * v, v, 0); };
  const PointLattice lattice = latticeOn(skewed, 21, 21);
  const Matrix3Xd up = normalsOf(lattice, [](double, double) { return Vector3d(0, 0, 1); });
  EXPECT_TRUE(
      mapAlongCurvature(lattice, up).values.isApprox(mapConformally(lattice).values, 1e-12));
}

/// A shallow saddle whose lines of curvature are turned by kTurn against its sides.
constexpr double kTurn = 0.3;
constexpr double kBend = 0.1;
Vector2d along() { return {std::cos(kTurn), std::sin(kTurn)}; }
Vector2d across() { return {-std::sin(kTurn), std::cos(kTurn)}; }
Vector3d saddle(double u, double v) {
  const Vector2d p(2 * u - 1, 2 * v - 1);
  return {p.x(), p.y(), kBend / 2 * (std::pow(p.dot(along()), 2) - std::pow(p.dot(across()), 2))};
}
Vector3d normalOfSaddle(double u, double v) {
  const Vector2d p(2 * u - 1, 2 * v - 1);
  const Vector2d slope = kBend * (p.dot(along()) * along() - p.dot(across()) * across());
  return {-slope.x(), -slope.y(), 1};
}

/// The mean angle, in the middle half of the surface, between lines of constant v and `along`.
double deviation(const PointLattice& lattice, const LatticeMap& map) {
  double sum = 0;
  int count = 0;
  for (const auto& triangle : map.triangles.colwise()) {
    const Matrix3Xd p = lattice.points(Eigen::all, triangle);
    if (p.topRows<2>().cwiseAbs().maxCoeff() > 0.5) continue;
    Eigen::Matrix2d edges, changes;
    edges << (p.col(1) - p.col(0)).head<2>(), (p.col(2) - p.col(0)).head<2>();
    const Eigen::Matrix2Xd values = map.values(Eigen::all, triangle);
    changes << values.col(1) - values.col(0), values.col(2) - values.col(0);
    const Vector2d line = edges * changes.inverse() * Vector2d(1, 0);  // Along which v stays.
    sum += std::abs(std::atan2(across().dot(line), along().dot(line)));
    ++count;
  }
  return sum / count;
}

TEST(PrincipalMap, TurnsTheNetTowardsTheLinesOfCurvature) {
  const PointLattice lattice = latticeOn(saddle, 41, 41);
  const LatticeMap map = mapAlongCurvature(lattice, normalsOf(lattice, normalOfSaddle));
  EXPECT_NEAR(deviation(lattice, mapConformally(lattice)), kTurn, 0.02);
  EXPECT_LT(deviation(lattice, map), 0.3 * kTurn);
}

}  // namespace
}  // namespace morphgrid
