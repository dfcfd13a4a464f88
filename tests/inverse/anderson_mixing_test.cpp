#include "inverse/anderson_mixing.h"

#include <gtest/gtest.h>

namespace morphgrid {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

// Of a linear residual b - A x it is GMRES: done after as many steps as there are unknowns, and
// one.
TEST(AndersonMixing, SolvesALinearProblemInAsManyStepsAsItHasUnknowns) {
  constexpr int kSize = 4;
  std::srand(1);
  const MatrixXd a = MatrixXd::Identity(kSize, kSize) + 0.4 * MatrixXd::Random(kSize, kSize);
  const VectorXd b = VectorXd::Random(kSize);
  AndersonMixing mixing(kSize);
  VectorXd x = VectorXd::Zero(kSize);
  for (int step = 0; step < kSize + 1; ++step) {
    EXPECT_GT((b - a * x).norm(), 1e-6) << step;
    x = mixing.next(x, b - a * x);
  }
  EXPECT_LT((b - a * x).norm(), 1e-10);
}

TEST(AndersonMixing, WithoutDepthIsThePlainIteration) {
  AndersonMixing mixing(0);
  const VectorXd x = VectorXd::Constant(3, 2.0);
  EXPECT_EQ(mixing.next(x, VectorXd::Ones(3)), VectorXd::Constant(3, 3.0));
  EXPECT_EQ(mixing.next(x, -VectorXd::Ones(3)), VectorXd::Constant(3, 1.0));
}

TEST(AndersonMixing, ForgetsWhenItIsTold) {
  AndersonMixing mixing(3);
  mixing.next(VectorXd::Zero(2), VectorXd::Ones(2));
  mixing.clear();
  EXPECT_EQ(mixing.next(VectorXd::Ones(2), VectorXd::Ones(2)), VectorXd::Constant(2, 2.0));
}

}  // namespace
}  // namespace morphgrid
