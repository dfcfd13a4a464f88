#include "propose/sight.h"

#include <gtest/gtest.h>

#include "tests/propose/bowls.h"

namespace morphgrid {
namespace {

using Eigen::Quaterniond;
using Eigen::Vector3d;

SightRating bestSight(const TriangleMesh& mesh) {
  return rateSights(mesh, listSights(mesh)).front();
}

TEST(Sight, TurnsItsDirectionToX) {
  for (const Sight& sight :
       listSights(turned(Quaterniond(0.9, 0.1, 0.2, 0.3).normalized(), bowl()))) {
    const Vector3d seen = sight.rotation() * sight.direction();
    EXPECT_NEAR((seen - Vector3d::UnitX()).norm(), 0, 1e-9) << sight.name;
  }
  EXPECT_NEAR((listSights(bowl()).front().direction() + Vector3d::UnitZ()).norm(), 0, 1e-12);
}

TEST(Sight, LooksIntoABowlWhicheverAxisItFaces) {
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {1.0, -1.0}) {
      const Vector3d facing = sign * Vector3d::Unit(axis);
      const auto best =
          bestSight(turned(Quaterniond::FromTwoVectors(Vector3d::UnitZ(), facing), bowl()));
      EXPECT_GT(best.sight.direction().dot(-facing), 0.999) << facing.transpose();
      EXPECT_GT(best.share, 0.9);
      EXPECT_GT(best.facing, 0.8);
    }
  }
}

TEST(Sight, LooksIntoABowlThatIsTilted) {
  const Vector3d facing = Vector3d(1, 1, 1).normalized();
  const TriangleMesh mesh = turned(Quaterniond::FromTwoVectors(Vector3d::UnitZ(), facing), bowl());
  const SightRating best = bestSight(mesh);
  EXPECT_GT(best.sight.direction().dot(-facing), 0.999);
  EXPECT_EQ(best.sight.name, "against the mean normal");
}

TEST(Sight, IsNotMisledByDebris) {
  TriangleMesh mesh = bowl();
  const Eigen::Index vertices = mesh.vertices.cols();
  const Eigen::Index triangles = mesh.triangles.cols();
  mesh.vertices.conservativeResize(3, vertices + 3);
  mesh.triangles.conservativeResize(3, triangles + 1);
  mesh.vertices.rightCols<3>() << 500, 500, 500.01, 300, 300.01, 300, -200, -200, -200;
  mesh.triangles.rightCols<1>() << int(vertices), int(vertices) + 1, int(vertices) + 2;
  const SightRating best = bestSight(mesh);
  EXPECT_GT(best.share, 0.9);
  EXPECT_EQ(best.sight.name, "along -z");
}

TEST(Sight, HasNoBoxOfADegenerateMesh) {
  TriangleMesh line = bowl(2);
  line.vertices.bottomRows<2>().setZero();
  for (const SightRating& rating : rateSights(line, listSights(line))) EXPECT_FALSE(rating.box);
}

}  // namespace
}  // namespace morphgrid
