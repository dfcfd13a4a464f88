#include "energy/joint_term.h"

#include <gtest/gtest.h>

#include <cmath>

namespace morphgrid {
namespace {

using Eigen::AngleAxisd;
using Eigen::Quaterniond;
using Eigen::Vector3d;

constexpr double kStep = 1e-6;

JointTerm sampleTerm() {
  return {.printed = {1, 2, 3}, .load = {0.3, -0.2, 0.5}, .holding = {7, 4, 9}, .turning = 5};
}

Quaterniond turnedBy(const Vector3d& turn, const Quaterniond& rotation) {
  return Quaterniond(AngleAxisd(turn.norm(), turn.normalized())) * rotation;
}

TEST(JointTerm, HoldsLikeASpringAndALever) {
  const JointTerm term = sampleTerm();
  const Quaterniond rotation(AngleAxisd(0.3, Vector3d::UnitY()));
  const JointTerm::Value at = term.evaluate(term.printed + Vector3d(0.1, 0, 0), rotation);
  EXPECT_NEAR(at.energy, 7 * 0.01 / 2 + 5 * (1 - std::cos(0.3)) - 0.3 * 0.1, 1e-14);
  EXPECT_LT((at.moment - 5 * std::sin(0.3) * Vector3d::UnitY()).norm(), 1e-14);
}

TEST(JointTerm, DerivativesAreThoseOfDifferences) {
  const JointTerm term = sampleTerm();
  const Vector3d position(1.1, 1.8, 3.3);
  const Quaterniond rotation(AngleAxisd(0.8, Vector3d(1, 2, -1).normalized()));
  const JointTerm::Value at = term.evaluate(position, rotation);
  for (int axis = 0; axis < 3; ++axis) {
    const Vector3d step = kStep * Vector3d::Unit(axis);
    const double byForce = (term.evaluate(position + step, rotation).energy -
                            term.evaluate(position - step, rotation).energy) /
                           (2 * kStep);
    EXPECT_NEAR(at.force[axis], byForce, 1e-8);
    const JointTerm::Value forth = term.evaluate(position, turnedBy(step, rotation));
    const JointTerm::Value back = term.evaluate(position, turnedBy(-step, rotation));
    EXPECT_NEAR(at.moment[axis], (forth.energy - back.energy) / (2 * kStep), 1e-8);
    const Vector3d change = (forth.moment - back.moment) / (2 * kStep);
    EXPECT_LT((term.momentByTurn(rotation).col(axis) - change).norm(), 1e-8);
  }
}

}  // namespace
}  // namespace morphgrid
