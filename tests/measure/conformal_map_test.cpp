#include "measure/conformal_map.h"

#include <gmock/gmock.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

#include "core/error.h"
#include "tests/measure/sample_lattices.h"

namespace morphgrid {
namespace {

using Eigen::Vector3d;
using testing::HasSubstr;

constexpr double kPi = std::numbers::pi;

/// A sector of an annulus: u runs outwards, v around.
constexpr double kInner = 1;
constexpr double kOuter = 3;
constexpr double kAngle = 1.5;
Vector3d sector(double u, double v) {
  const double radius = kInner + u * (kOuter - kInner);
  return {radius * std::cos(kAngle * v), radius * std::sin(kAngle * v), 0};
}

/// The unit sphere between two longitudes (u) and latitudes (v).
constexpr double kLongitudes = 1.2;
constexpr double kSouth = -0.4;
constexpr double kNorth = 1.1;
Vector3d sphere(double u, double v) {
  const double longitude = u * kLongitudes;
  const double latitude = kSouth + v * (kNorth - kSouth);
  return {std::cos(latitude) * std::cos(longitude), std::cos(latitude) * std::sin(longitude),
          std::sin(latitude)};
}
double mercator(double latitude) { return std::asinh(std::tan(latitude)); }

/// Largest |difference| of the map's values from exact ones, (u, v) of the parameters.
template <typename Exact>
double largestError(const LatticeMap& map, Exact exact) {
  double largest = 0;
  for (int j = 0; j < map.countV; ++j) {
    for (int i = 0; i < map.countU; ++i) {
      const Eigen::Vector2d value =
          exact(double(i) / (map.countU - 1), double(j) / (map.countV - 1));
      largest =
          std::max(largest, (map.values.col(j * map.countU + i) - value).lpNorm<Eigen::Infinity>());
    }
  }
  return largest;
}

TEST(ConformalMap, OfARectangleIsTheIdentity) {
  // Unevenly sampled inside: linear functions are harmonic on any triangulation.
  const auto x = [](double u, double v) { return u + 0.1 * std::sin(kPi * u) * (1 + v); };
  const auto y = [](double u, double v) { return v + 0.05 * std::sin(kPi * v) * std::cos(2 * u); };
  const LatticeMap map = mapConformally(
      latticeOn([&](double u, double v) { return Vector3d(3 * x(u, v), 5, 2 * y(u, v)); }, 13, 8));
  EXPECT_LT(
      largestError(map, [&](double u, double v) { return Eigen::Vector2d(x(u, v), y(u, v)); }),
      1e-13);
  EXPECT_NEAR(map.modulus, 2.0 / 3, 1e-13);
}

TEST(ConformalMap, OfACylinderIsThatOfTheSheet) {
  const LatticeMap map = mapConformally(latticeOn(
      [](double u, double v) { return Vector3d(std::cos(2 * u), std::sin(2 * u), 3 * v); }, 21, 9));
  EXPECT_LT(largestError(map, [](double u, double v) { return Eigen::Vector2d(u, v); }), 1e-13);
  EXPECT_NEAR(map.modulus, 3 / (20 * 2 * std::sin(2.0 / 40)), 1e-13);  // A prism's chords.
}

TEST(ConformalMap, OfASectorIsTheLogarithmAndConvergesAtSecondOrder) {
  const double logarithm = std::log(kOuter / kInner);
  const auto exact = [&](double u, double v) {
    return Eigen::Vector2d(std::log(1 + u * (kOuter - kInner) / kInner) / logarithm, v);
  };
  const LatticeMap coarse = mapConformally(latticeOn(sector, 13, 11));
  const LatticeMap fine = mapConformally(latticeOn(sector, 25, 21));
  EXPECT_LT(largestError(fine, exact), 1e-3);
  EXPECT_NEAR(std::log2(largestError(coarse, exact) / largestError(fine, exact)), 2, 0.2);
  EXPECT_NEAR(fine.modulus, kAngle / logarithm, 1e-3);
  EXPECT_NEAR(
      std::log2((coarse.modulus - kAngle / logarithm) / (fine.modulus - kAngle / logarithm)), 2,
      0.2);
}

TEST(ConformalMap, OfASphereIsMercators) {
  const double height = mercator(kNorth) - mercator(kSouth);
  const auto exact = [&](double u, double v) {
    return Eigen::Vector2d(u,
                           (mercator(kSouth + v * (kNorth - kSouth)) - mercator(kSouth)) / height);
  };
  const LatticeMap coarse = mapConformally(latticeOn(sphere, 13, 11));
  const LatticeMap fine = mapConformally(latticeOn(sphere, 25, 21));
  EXPECT_LT(largestError(fine, exact), 1e-3);
  EXPECT_NEAR(std::log2(largestError(coarse, exact) / largestError(fine, exact)), 2, 0.3);
  EXPECT_NEAR(fine.modulus, height / kLongitudes, 2e-3);
}

TEST(ConformalMap, OfARhombusHasTheModulusOne) {
  const LatticeMap map = mapConformally(latticeOn(
      [](double u, double v) -> Vector3d {
        return u * Vector3d::UnitX() + v * Vector3d(0.5, std::sqrt(0.75), 0);
      },
      17, 17));
  EXPECT_NEAR(map.modulus, 1, 1e-12);
  // Mirrored in the long diagonal, u and v change places.
  EXPECT_NEAR(map.values(0, 5 * 17 + 3), map.values(1, 3 * 17 + 5), 1e-12);
}

TEST(ConformalMap, DoesNotDependOnUnitsOrPlace) {
  const LatticeMap map = mapConformally(latticeOn(sphere, 9, 11));
  PointLattice lattice = latticeOn(sphere, 9, 11);
  const Eigen::Affine3d motion = Eigen::Translation3d(5, -3, 2) *
                                 Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, -1).normalized()) *
                                 Eigen::Scaling(1e3);
  lattice.points = motion * lattice.points;
  const LatticeMap moved = mapConformally(lattice);
  EXPECT_LT((moved.values - map.values).cwiseAbs().maxCoeff(), 1e-11);
  EXPECT_NEAR(moved.modulus, map.modulus, 1e-11);
}

TEST(ConformalMap, RefusesACollapsedSide) {
  const PointLattice triangle =
      latticeOn([](double u, double v) { return Vector3d(u, u * v, 0); }, 9, 9);
  try {
    mapConformally(triangle);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("no area near (0.125, 0, 0), at u = 0.125, v = 0 of"));
    EXPECT_THAT(error.what(), HasSubstr("design.net = \"isoline\""));
  }
}

}  // namespace
}  // namespace morphgrid
