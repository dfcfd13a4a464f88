#include "inverse/bounded_lbfgs.h"

#include <gtest/gtest.h>

namespace morphgrid {
namespace {

using Eigen::VectorXd;

// 1/2 sum c_n (x_n - t_n)^2 over a box: its answer is the projection of t.
TEST(BoundedLbfgs, FindsTheMinimumOfAQuadraticInABox) {
  constexpr Eigen::Index kSize = 12;
  const VectorXd stiffness = VectorXd::LinSpaced(kSize, 1, 30);
  const VectorXd wanted = VectorXd::LinSpaced(kSize, -2, 2);
  const VectorXd high = VectorXd::Constant(kSize, 1);
  BoundedLbfgs lbfgs(-high, high);
  const auto gradientAt = [&](const VectorXd& x) {
    return VectorXd(stiffness.cwiseProduct(x - wanted));
  };
  const auto valueAt = [&](const VectorXd& x) {
    return 0.5 * (x - wanted).cwiseProduct(gradientAt(x)).sum();
  };
  VectorXd x = VectorXd::Zero(kSize);
  for (int step = 0; step < 60; ++step) {
    const VectorXd gradient = gradientAt(x);
    const VectorXd direction = lbfgs.direction(x, gradient, 0.1);
    double length = 1;
    VectorXd next = lbfgs.project(x + direction);
    while (valueAt(next) > valueAt(x) && length > 1e-10) {
      length /= 2;
      next = lbfgs.project(x + length * direction);
    }
    lbfgs.add(next - x, gradientAt(next) - gradient);
    x = next;
  }
  EXPECT_LT((x - lbfgs.project(wanted)).cwiseAbs().maxCoeff(), 1e-6);
}

TEST(BoundedLbfgs, HeldVariablesDoNotMove) {
  const VectorXd high = VectorXd::Constant(2, 1);
  BoundedLbfgs lbfgs(-high, high);
  const VectorXd x = Eigen::Vector2d(1, 0);
  const VectorXd direction = lbfgs.direction(x, Eigen::Vector2d(-1, -2), 0.5);
  EXPECT_EQ(direction[0], 0);
  EXPECT_NEAR(direction[1], 0.5, 1e-15);
}

TEST(BoundedLbfgs, NothingToDoGivesNoDirection) {
  const VectorXd high = VectorXd::Constant(2, 1);
  const BoundedLbfgs lbfgs(-high, high);
  EXPECT_EQ(lbfgs.direction(Eigen::Vector2d(0, 0), Eigen::Vector2d(0, 0), 0.5).norm(), 0);
}

}  // namespace
}  // namespace morphgrid
