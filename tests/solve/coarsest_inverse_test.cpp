#include "solve/coarsest_inverse.h"

#include <gtest/gtest.h>

#include <Eigen/Core>
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
  const MatrixXd inverse = computeCoarsestInverse(matrix, points());
  EXPECT_TRUE((matrix * inverse * matrix).isApprox(matrix, 1e-5));
  EXPECT_TRUE((inverse * rigid).isApprox(rigid / matrix.diagonal().mean(), 1e-5));
}

TEST(CoarsestInverse, HoldsMotionsThatNothingHolds) {
  MatrixXd matrix = freeMatrix();
  for (int unknown = 2; unknown < 24; unknown += 6) {
    matrix.row(unknown).setZero();
    matrix.col(unknown).setZero();
  }
  const MatrixXd inverse = computeCoarsestInverse(matrix, points());
  EXPECT_TRUE(inverse.isApprox(inverse.transpose(), 1e-9));
  EXPECT_LT(inverse.diagonal()(2), 2);
}

TEST(CoarsestInverse, RefusesWhatIsNotFinite) {
  MatrixXd matrix = freeMatrix();
  matrix(3, 3) = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(computeCoarsestInverse(matrix, points()), DeviceError);
}

}  // namespace
}  // namespace morphgrid
