#include "solve/lbfgs.h"

#include <gtest/gtest.h>

#include <Eigen/LU>
#include <deque>

namespace morphgrid {
namespace {

constexpr int kSize = 12;
using Vector = Eigen::Matrix<double, kSize, 1>;
using Matrix = Eigen::Matrix<double, kSize, kSize>;

struct Pair {
  Vector step;
  Vector change;
};

/// The inverse Hessian that L-BFGS stands for, built by the BFGS formula pair by pair.
Matrix denseInverse(const Matrix& initial, const std::deque<Pair>& pairs) {
  Matrix inverse = initial;
  for (const Pair& pair : pairs) {
    const double rho = 1 / pair.step.dot(pair.change);
    const Matrix left = Matrix::Identity() - rho * pair.step * pair.change.transpose();
    inverse = left * inverse * left.transpose() + rho * pair.step * pair.step.transpose();
  }
  return inverse;
}

/// What the device would do with the weights.
Vector direction(PairHistory& history, const Pair (&slots)[kPairs], const Vector& gradient,
                 const Matrix& initial) {
  Dots dots{};
  for (int i = 0; i < 3; ++i) {
    dots.gradient[i] = slots[i].step.dot(gradient);
    for (int j = 0; j < 3; ++j) dots.products(i, j) = slots[i].step.dot(slots[j].change);
  }
  const auto first = history.firstLoop(dots);
  Vector rightSide = gradient;
  for (int i = 0; i < 3; ++i) rightSide += double(first[i]) * slots[i].change;
  Vector result = initial * rightSide;
  for (int i = 0; i < 3; ++i) dots.correction[i] = slots[i].change.dot(result);
  const auto second = history.secondLoop(dots);
  for (int i = 0; i < 3; ++i) result += double(second[i]) * slots[i].step;
  return result;
}

TEST(Lbfgs, MatchesTheDenseFormulaWhileTheSlotsFillAndTurnOver) {
  std::srand(4);
  const Matrix root = Matrix::Random();
  const Matrix hessian = root * root.transpose() + Matrix::Identity();
  const Matrix initial = Vector::Random().cwiseAbs().asDiagonal();
  PairHistory history;
  Pair slots[kPairs];
  for (Pair& slot : slots) slot = {Vector::Zero(), Vector::Zero()};
  std::deque<Pair> newest;
  for (int n = 0; n < 6; ++n) {
    const Vector step = Vector::Random();
    const Pair pair{step, hessian * step};
    slots[history.nextSlot()] = pair;
    Eigen::Matrix3d products;
    for (int i = 0; i < 3; ++i) {
      for (int j = 0; j < 3; ++j) products(i, j) = slots[i].step.dot(slots[j].change);
    }
    history.add(products);
    newest.push_back(pair);
    if (newest.size() > kPairs) newest.pop_front();
    const Vector gradient = Vector::Random();
    const Vector expected = denseInverse(initial, newest) * gradient;
    EXPECT_LT((direction(history, slots, gradient, initial) - expected).norm(),
              1e-5 * expected.norm());
  }
}

TEST(Lbfgs, PairsOfNegativeCurvatureAreDropped) {
  PairHistory history;
  history.add(-Eigen::Matrix3d::Identity());
  EXPECT_TRUE(history.empty());
}

}  // namespace
}  // namespace morphgrid
