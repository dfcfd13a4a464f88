#include "solve/coarsest_inverse.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <Eigen/QR>
#include <limits>

#include "core/error.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Four points, not in one plane.
Matrix3Xd points() {
  Matrix3Xd centres(3, 4);
  centres << 0, 2, 0, 2.5, 0, 0, 3, 3, 0, 0.5, -0.5, 1;
  return centres;
}

/// Holds everything but rigid motions, and has these as its null space.
MatrixXd freeMatrix() {
  const MatrixXd rigid = orthonormalRigidMotions(points());
  return 5 * (MatrixXd::Identity(24, 24) - rigid * rigid.transpose());
}

TEST(CoarsestInverse, RigidMotionsAreOrthonormal) {
  const MatrixXd rigid = orthonormalRigidMotions(points());
  EXPECT_TRUE((rigid.transpose() * rigid).isApprox(MatrixXd::Identity(6, 6), 1e-12));
  VectorXd turn(24);  // About z.
  for (int n = 0; n < 4; ++n) {
    turn.segment<6>(6 * n) << -points()(1, n), points()(0, n), 0, 0, 0, 1;
  }
  EXPECT_TRUE((rigid * (rigid.transpose() * turn)).isApprox(turn, 1e-12));
}

TEST(CoarsestInverse, InvertsWhatIsNotRigidAndHoldsTheRest) {
  const MatrixXd matrix = freeMatrix();
  const MatrixXd rigid = orthonormalRigidMotions(points());
  const MatrixXd inverse = computeCoarsestInverse(matrix, points(), 4);
  EXPECT_TRUE((matrix * inverse * matrix).isApprox(matrix, 1e-5));
  EXPECT_TRUE((inverse * rigid).isApprox(rigid / matrix.diagonal().mean(), 1e-5));
}

TEST(CoarsestInverse, HoldsMotionsThatNothingHolds) {
  MatrixXd matrix = freeMatrix();
  for (int unknown = 2; unknown < 24; unknown += 6) {
    matrix.row(unknown).setZero();
    matrix.col(unknown).setZero();
  }
  const MatrixXd inverse = computeCoarsestInverse(matrix, points(), 4);
  EXPECT_TRUE(inverse.isApprox(inverse.transpose(), 1e-9));
  EXPECT_LT(inverse.diagonal()(2), 2);
}

/// Positive definite, when shift > 0 is large enough.
MatrixXd blockTridiagonal(Eigen::Index blocks, Eigen::Index b, double shift) {
  MatrixXd matrix = MatrixXd::Zero(blocks * b, blocks * b);
  for (Eigen::Index n = 0; n < blocks; ++n) {
    matrix.block(n * b, n * b, b, b) = MatrixXd::Random(b, b);
    if (n > 0) {
      matrix.block(n * b, (n - 1) * b, b, b) = MatrixXd::Random(b, b);
    }
  }
  return matrix + matrix.transpose().eval() + shift * MatrixXd::Identity(blocks * b, blocks * b);
}

TEST(BlockTridiagonal, IsInvertedAsAWhole) {
  for (const Eigen::Index blocks : {1, 2, 5}) {
    const MatrixXd matrix = blockTridiagonal(blocks, 6, 20);
    const auto inverse = invertBlockTridiagonal(matrix, 6);
    ASSERT_TRUE(inverse);
    EXPECT_TRUE((*inverse * matrix).isIdentity(1e-12)) << blocks;
    EXPECT_TRUE(inverse->isApprox(inverse->transpose(), 1e-14)) << blocks;
  }
}

TEST(BlockTridiagonal, IsRefusedWhenIndefinite) {
  EXPECT_FALSE(invertBlockTridiagonal(blockTridiagonal(4, 6, 0), 6));
}

TEST(CoarsestInverse, OfRowsIsThatOfTheWhole) {
  Matrix3Xd centres = Matrix3Xd::Random(3, 12);
  // Springs between neighbouring rows, which rigid motions leave at rest.
  const MatrixXd rigid = orthonormalRigidMotions(centres);
  MatrixXd matrix = MatrixXd::Zero(72, 72);
  for (int row = 0; row < 3; ++row) {
    const Eigen::Index first = 18 * row;
    const MatrixXd part = rigid.middleRows(first, 36);
    const MatrixXd basis =
        Eigen::HouseholderQR<MatrixXd>(part).householderQ() * MatrixXd::Identity(36, 6);
    matrix.block(first, first, 36, 36) += MatrixXd::Identity(36, 36) - basis * basis.transpose();
  }
  const MatrixXd byRows = computeCoarsestInverse(matrix, centres, 3);
  const MatrixXd whole = computeCoarsestInverse(matrix, centres, 12);
  EXPECT_TRUE(byRows.isApprox(whole, 1e-9));
  EXPECT_TRUE((matrix * byRows * matrix).isApprox(matrix, 1e-5));
}

TEST(CoarsestInverse, RefusesWhatIsNotFinite) {
  MatrixXd matrix = freeMatrix();
  matrix(3, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(computeCoarsestInverse(matrix, points(), 4), DeviceError);
}

}  // namespace
}  // namespace morphgrid
