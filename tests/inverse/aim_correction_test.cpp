#include "inverse/aim_correction.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;

Matrix3Xd arch() {
  Matrix3Xd points(3, 21);
  for (int n = 0; n < 21; ++n) {
    const double x = n / 10.0 - 1;
    points.col(n) << x, 0.3 * std::sin(2 * x), 0.5 * x * x;
  }
  return points;
}

Eigen::Matrix3d turnedOver(double angle) {
  return Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitX()).toRotationMatrix();
}

/// What springs back by a fifth, more in the middle, and lies elsewhere.
Matrix3Xd sprungBack(const Matrix3Xd& aim) {
  Matrix3Xd reached = aim;
  for (Eigen::Index n = 0; n < aim.cols(); ++n) {
    reached(2, n) *= 0.8 - 0.1 * std::cos(3 * aim(0, n));
  }
  return turnedOver(2) * reached;
}

TEST(AimCorrection, AimsSoThatTheTargetIsReached) {
  const Matrix3Xd targets = arch();
  AimCorrection correction(targets, targets);
  Matrix3Xd reached = sprungBack(targets);
  for (int round = 0; round < 10; ++round) {
    reached = sprungBack(correction.next(reached));
    correction.take();
  }
  Matrix3Xd aligned = turnedOver(-2) * reached;
  aligned.colwise() -= (aligned - targets).rowwise().mean().eval();
  EXPECT_LT((aligned - targets).cwiseAbs().maxCoeff(), 1e-6);
  EXPECT_FALSE(correction.isExhausted());
}

TEST(AimCorrection, GoesHalfAsFarAfterEachRefusalAndGivesUp) {
  const Matrix3Xd targets = arch();
  AimCorrection correction(targets, targets);
  const Matrix3Xd reached = sprungBack(targets);
  const double whole = (correction.next(reached) - targets).norm();
  correction.refuse();
  EXPECT_NEAR((correction.next(reached) - targets).norm(), whole / 2, 1e-12);
  EXPECT_EQ(correction.aim(), targets);
  for (int n = 0; n < 3; ++n) correction.refuse();
  EXPECT_TRUE(correction.isExhausted());
}

}  // namespace
}  // namespace morphgrid
