#include "measure/mapped_net.h"

#include <gmock/gmock.h>

#include <Eigen/LU>
#include <cmath>

#include "core/error.h"
#include "measure/surface_measurement.h"
#include "surface/read_patch.h"
#include "tests/measure/sample_lattices.h"
#include "tests/support/folders.h"

namespace morphgrid {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using testing::HasSubstr;

Vector3d skewed(double u, double v) {
  return {2 * u + 0.7 * v, 1.5 * v + 0.3 * u * v + 0.2 * std::sin(3 * u), std::sin(2 * u) * v};
}

/// The map at parameters: barycentric on the triangle that holds them, searched among all.
Vector2d valueAt(const LatticeMap& map, const Vector2d& parameters) {
  const Vector2d place = parameters.cwiseProduct(Vector2d(map.countU - 1, map.countV - 1));
  Vector2d value;
  double deepest = -1;
  for (const auto& triangle : map.triangles.colwise()) {
    Eigen::Matrix3d corners;
    for (int k = 0; k < 3; ++k) {
      corners.col(k) << triangle[k] % map.countU, triangle[k] / map.countU, 1;
    }
    const Vector3d shares = corners.inverse() * Vector3d(place.x(), place.y(), 1);
    if (shares.minCoeff() > deepest) {
      deepest = shares.minCoeff();
      value = map.values(Eigen::all, triangle) * shares;
    }
  }
  return value;
}

PointLattice pointsOf(const Surface& surface, const Net& net) {
  return {net.nodesU + 1, net.nodesV + 1, pointsAt(surface, net.parameters)};
}

TEST(OrthogonalNet, InvertsTheMap) {
  const LatticeMap map = mapConformally(latticeOn(skewed, 31, 25));
  const Net net = mappedNet(map, 11, 7);
  for (int j = 0; j <= 7; ++j) {
    for (int i = 0; i <= 11; ++i) {
      const Vector2d value = valueAt(map, net.parameters.col(net.index(i, j)));
      EXPECT_LT((value - Vector2d(i / 11.0, j / 7.0)).norm(), 1e-9) << i << ", " << j;
    }
  }
}

TEST(OrthogonalNet, KeepsSidesAndCorners) {
  const LatticeMap map = mapConformally(latticeOn(skewed, 31, 25));
  const Net net = mappedNet(map, 11, 7);
  for (int i = 0; i <= 11; ++i) {
    EXPECT_EQ(net.parameters(1, net.index(i, 0)), 0);
    EXPECT_EQ(net.parameters(1, net.index(i, 7)), 1);
  }
  for (int j = 0; j <= 7; ++j) {
    EXPECT_EQ(net.parameters(0, net.index(0, j)), 0);
    EXPECT_EQ(net.parameters(0, net.index(11, j)), 1);
  }
  EXPECT_EQ(net.parameters.col(net.index(11, 0)), Vector2d(1, 0));
  EXPECT_EQ(net.parameters.col(net.index(0, 7)), Vector2d(0, 1));
}

TEST(OrthogonalNet, OfASectorGrowsOutwards) {
  const auto sector = [](double u, double v) {
    return Vector3d((1 + 2 * u) * std::cos(v), (1 + 2 * u) * std::sin(v), 0);
  };
  const Net net = mappedNet(mapConformally(latticeOn(sector, 81, 41)), 10, 6);
  for (int i = 0; i <= 10; ++i) {
    const double radius = std::pow(3, i / 10.0);
    EXPECT_NEAR(net.parameters(0, net.index(i, 2)), (radius - 1) / 2, 1e-4);
    EXPECT_NEAR(net.parameters(1, net.index(i, 2)), 2.0 / 6, 1e-4);
  }
}

TEST(OrthogonalNet, OnALatticeOfOneCellIsLinear) {
  const Net net = mappedNet(
      mapConformally(latticeOn([](double u, double v) { return Vector3d(u, v, 0); }, 2, 2)), 3, 5);
  EXPECT_LT((net.parameters - isolineNet(3, 5).parameters).cwiseAbs().maxCoeff(), 1e-14);
}

TEST(OrthogonalNet, TellsAFold) {
  LatticeMap map =
      mapConformally(latticeOn([](double u, double v) { return Vector3d(u, v, 0); }, 9, 9));
  for (const int j : {3, 4, 5}) {
    for (int i = 1; i < 8; ++i) map.values(0, 9 * j + i) = (8 - i) / 8.0;  // Runs backwards.
  }
  try {
    mappedNet(map, 17, 17);
    FAIL();
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), HasSubstr("folded in node"));
  }
}

struct PaperPatch {
  const char* name;
  int nodesU, nodesV;
  double isolineDeviation;  ///< Mean, degrees: at least.
};

class PaperPatches : public testing::TestWithParam<PaperPatch> {};

TEST_P(PaperPatches, CrossAtRightAnglesAwayFromTheCorners) {
  const auto& [name, nodesU, nodesV, isolineDeviation] = GetParam();
  const BezierPatch patch = readPatch(sourceFolder() / "scenes/patches" / name);
  const auto degrees = [](double radians) { return radians * 180 / std::acos(-1.0); };
  const LatticeMap map =
      mapConformally(latticeOn([&](double u, double v) { return patch.point(u, v); }, 81, 81));
  const auto middleOf = [&](const Net& net, int margin) {
    const PointLattice whole = pointsOf(patch, net);
    PointLattice middle{whole.countU - 2 * margin, whole.countV - 2 * margin, {}};
    middle.points.resize(3, middle.countU * middle.countV);
    for (int j = 0; j < middle.countV; ++j) {
      for (int i = 0; i < middle.countU; ++i) {
        middle.points.col(middle.index(i, j)) = whole.at(i + margin, j + margin);
      }
    }
    return assessNet(middle);
  };
  const NetQuality coarse = middleOf(mappedNet(map, nodesU, nodesV), 3);
  EXPECT_LT(degrees(coarse.largestAngleDeviation), 6);
  EXPECT_LT(degrees(coarse.meanAngleDeviation), 1.5);
  EXPECT_GT(degrees(middleOf(isolineNet(nodesU, nodesV), 3).meanAngleDeviation), isolineDeviation);
  // What is left is that chords are not tangents.
  const NetQuality fine = middleOf(mappedNet(map, 2 * nodesU, 2 * nodesV), 6);
  EXPECT_LT(fine.meanAngleDeviation, 0.55 * coarse.meanAngleDeviation);
}

INSTANTIATE_TEST_SUITE_P(, PaperPatches,
                         testing::Values(PaperPatch{"patch.toml", 30, 21, 6},
                                         PaperPatch{"egg_chair.toml", 16, 20, 7},
                                         PaperPatch{"iris_petal.toml", 15, 35, 4}),
                         [](const auto& test) {
                           const std::string name = test.param.name;
                           return name.substr(0, name.find('.'));
                         });

TEST(OrthogonalNet, OfAMirroredSurfaceIsMirrored) {
  const BezierPatch chair = readPatch(sourceFolder() / "scenes/patches/egg_chair.toml");
  const Net net = mappedNet(
      mapConformally(latticeOn([&](double u, double v) { return chair.point(u, v); }, 41, 41)), 8,
      10);
  for (int j = 0; j <= 10; ++j) {
    for (int i = 0; i <= 8; ++i) {
      const Vector2d here = net.parameters.col(net.index(i, j));
      const Vector2d across = net.parameters.col(net.index(8 - i, j));
      EXPECT_NEAR(here.x(), 1 - across.x(), 1e-6);
      EXPECT_NEAR(here.y(), across.y(), 1e-6);
    }
  }
}

}  // namespace
}  // namespace morphgrid
