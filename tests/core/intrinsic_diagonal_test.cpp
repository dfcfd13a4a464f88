#include "core/intrinsic_diagonal.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>

#include "core/bounding_diagonal.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

const Eigen::Matrix3d kTurn =
    Eigen::AngleAxisd(0.7, Vector3d(1, 2, -1).normalized()).toRotationMatrix();

/// A lattice of a length and a width, bent by a height.
Matrix3Xd vault(double length, double width, double height) {
  constexpr int kCount = 9;
  Matrix3Xd points(3, kCount * kCount);
  for (int n = 0; n < points.cols(); ++n) {
    const double x = double(n % kCount) / (kCount - 1);
    const double y = double(n / kCount) / (kCount - 1);
    points.col(n) = Vector3d(length * x, width * y, height * 4 * x * (1 - x));
  }
  return points;
}

TEST(IntrinsicDiagonal, OfABoxIsItsDiagonal) {
  EXPECT_NEAR(intrinsicDiagonal(vault(12, 4, 3)), 13, 1e-12);
  EXPECT_NEAR(intrinsicDiagonal(vault(4, 3, 0)), 5, 1e-12);
}

TEST(IntrinsicDiagonal, TurnsWithThePoints) {
  // The square's moments are equal: its axes of inertia may lie anywhere in its plane.
  for (const Matrix3Xd& points : {vault(12, 4, 3), vault(4, 3, 0), vault(5, 5, 0)}) {
    const Matrix3Xd turned = (kTurn * points).colwise() + Vector3d(100, -20, 3);
    const double diagonal = intrinsicDiagonal(points);
    EXPECT_NEAR(diagonal, boundingDiagonal(points), 1e-12);
    EXPECT_NEAR(intrinsicDiagonal(turned), diagonal, 1e-11);
    EXPECT_GT(std::abs(boundingDiagonal(turned) - diagonal), 0.05 * diagonal);
    Matrix3Xd mirrored = turned;
    mirrored.row(0) *= -1;
    EXPECT_NEAR(intrinsicDiagonal(mirrored), diagonal, 1e-11);
  }
}

TEST(IntrinsicDiagonal, OfALineOrAPoint) {
  const Matrix3Xd line = kTurn * vault(7, 0, 0);
  EXPECT_NEAR(intrinsicDiagonal(line), 7, 1e-12);
  EXPECT_EQ(intrinsicDiagonal(Vector3d(1, 2, 3)), 0);
}

}  // namespace
}  // namespace morphgrid
