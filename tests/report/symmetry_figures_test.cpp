#include "report/symmetry_figures.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

constexpr GridShape kShape{5, 4, 3};

/// A layer of points height(x, y) above the middle of its plane, turned and moved.
template <typename Height>
Matrix3Xd layerOver(const Height& height) {
  Matrix3Xd layer(3, kShape.layerVertexCount());
  forEachVertex(kShape.layer(), [&](const GridPlace& place) {
    const double x = place.i - 2.0;
    const double y = place.j - 1.5;
    layer.col(kShape.index(place)) = Vector3d(x, y, height(x, y));
  });
  const Eigen::Isometry3d moved =
      Eigen::Translation3d(3, 1, 2) * Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized());
  return moved * layer;
}

double ridge(double x, double y) { return 0.3 * x * x + 0.1 * y; }       // Even in x.
double twist(double x, double y) { return 0.2 * x * y + 0.05 * x * x; }  // Even in (x, y).

TEST(SymmetryFigures, FindsMirrorsAndHalfTurns) {
  const Matrix3Xd mirrored = layerOver(ridge);
  const auto mirror = computeSymmetry(kShape, mirrored, mirrored);
  ASSERT_TRUE(mirror);
  EXPECT_EQ(mirror->kind, Symmetry::mirrorAcrossU);
  EXPECT_LT(mirror->targetPercent, 1e-9);
  const Matrix3Xd turned = layerOver(twist);
  const auto halfTurn = computeSymmetry(kShape, turned, turned);
  ASSERT_TRUE(halfTurn);
  EXPECT_EQ(halfTurn->kind, Symmetry::halfTurn);
  const auto none = [](double x, double y) { return 0.3 * x * x * y + 0.2 * y * x + 0.1 * x * x; };
  EXPECT_FALSE(computeSymmetry(kShape, layerOver(none), mirrored));
}

// One vertex of 20 moved by 0.1: the twin differs there and at its partner.
TEST(SymmetryFigures, TellsWhatTheResultLost) {
  const Matrix3Xd target = layerOver(ridge);
  Matrix3Xd result = target;
  result.col(0) += Vector3d(0, 0, 0.1);
  const auto symmetry = computeSymmetry(kShape, target, result);
  ASSERT_TRUE(symmetry);
  const Vector3d box = target.rowwise().maxCoeff() - target.rowwise().minCoeff();
  EXPECT_NEAR(symmetry->resultPercent, 100 * 0.1 * std::sqrt(2.0 / 20) / box.norm(), 0.2);
  EXPECT_GT(symmetry->resultPercent, 0.3);
}

TEST(SymmetryFigures, OfSeveralTakesTheOneKeptWorst) {
  const auto bowl = [](double x, double y) { return 0.1 * (x * x + y * y); };
  const auto tilted = [](double x, double y) { return 0.1 * (x * x + y * y) + 0.02 * y * y * y; };
  const auto symmetry = computeSymmetry(kShape, layerOver(bowl), layerOver(tilted));
  ASSERT_TRUE(symmetry);
  EXPECT_NE(symmetry->kind, Symmetry::mirrorAcrossU);
}

}  // namespace
}  // namespace morphgrid
