#include "energy/beam_term.h"

#include <gtest/gtest.h>

#include <numbers>
#include <random>

#include "grid/bar_section.h"

namespace morphgrid {
namespace {

using Eigen::Vector3d;
using Vector9d = Eigen::Matrix<double, 9, 1>;

/// A bar that is bent, twisted and stretched.
class BentBeam : public testing::Test {
 protected:
  struct State {
    Vector3d arm;
    Eigen::Quaterniond a, b;
  };

  static Eigen::Quaterniond turn(const Vector3d& by) {
    return by.norm() > 0 ? Eigen::Quaterniond(Eigen::AngleAxisd(by.norm(), by.normalized()))
                         : Eigen::Quaterniond::Identity();
  }

  static State moved(const State& state, const Vector9d& by) {
    return {state.arm + by.head<3>(), turn(by.segment<3>(3)) * state.a,
            turn(by.tail<3>()) * state.b};
  }

  BeamTerm::Ends<double> ends(const State& state) const {
    return term_.endsAt(state.arm, state.a, state.b);
  }

  BeamTerm term_{
      rectangularSection({.width = 0.3, .height = 0.2, .poisson = 0.45, .joint = 0.05}, 7), 0.9,
      BeamTerm::axesOf(Vector3d(0.8, 0.6, 0), true)};
  State state_{{0.7, 0.4, 0.3}, turn({0.3, -0.2, 0.4}), turn({-0.1, 0.4, 0.2})};
};

TEST_F(BentBeam, GradientIsTheEnergysDifference) {
  const Vector9d gradient = term_.evaluate(ends(state_)).gradient;
  for (int n = 0; n < 9; ++n) {
    const double h = 1e-5;
    const Vector9d step = h * Vector9d::Unit(n);
    const double difference =
        term_.energy(ends(moved(state_, step))) - term_.energy(ends(moved(state_, -step)));
    EXPECT_NEAR(gradient[n], difference / (2 * h), 1e-8 * gradient.norm()) << n;
  }
}

TEST_F(BentBeam, HessianIsTheGradientsDifference) {
  const auto hessian = term_.hessian(ends(state_));
  for (int n = 0; n < 9; ++n) {
    const double h = 1e-5;
    const Vector9d step = h * Vector9d::Unit(n);
    const Vector9d difference = term_.evaluate(ends(moved(state_, step))).gradient -
                                term_.evaluate(ends(moved(state_, -step))).gradient;
    EXPECT_LT((hessian.col(n) - difference / (2 * h)).norm(), 1e-8 * hessian.norm()) << n;
  }
}

TEST_F(BentBeam, GradientByRestIsItsDifference) {
  const double h = 1e-5;
  BeamTerm longer = term_, shorter = term_;
  longer.rest += h;
  shorter.rest -= h;
  const Vector9d difference =
      longer.evaluate(ends(state_)).gradient - shorter.evaluate(ends(state_)).gradient;
  const Vector9d derivative = term_.gradientByRest(ends(state_));
  EXPECT_LT((derivative - difference / (2 * h)).norm(), 1e-8 * derivative.norm());
}

TEST_F(BentBeam, MovingRigidlyCostsNothing) {
  const Eigen::Quaterniond whole = turn({1, -2, 0.5});
  const State turned{whole * state_.arm, whole * state_.a, whole * state_.b};
  EXPECT_NEAR(term_.energy(ends(turned)), term_.energy(ends(state_)),
              1e-14 * term_.energy(ends(state_)));
}

TEST_F(BentBeam, ForcesAndMomentsAreInBalance) {
  const Vector9d gradient = term_.evaluate(ends(state_)).gradient;
  const Vector3d about =
      state_.arm.cross(gradient.head<3>()) + gradient.segment<3>(3) + gradient.tail<3>();
  EXPECT_LT(about.norm(), 1e-14 * gradient.norm());
}

TEST_F(BentBeam, WithoutStrainGaussNewtonIsExact) {
  const State straight{(0.9 + 2 * 0.05) * Vector3d(0.8, 0.6, 0), turn(Vector3d::Zero()),
                       turn(Vector3d::Zero())};
  const auto exact = term_.hessian(ends(straight));
  EXPECT_LT((term_.gaussNewton(ends(straight)) - exact).norm(), 1e-13 * exact.norm());
}

/// Stiffnesses of textbooks: end loads on a clamped bar of length L.
TEST(BeamStiffness, IsThatOfACantilever) {
  const BarSection section = rectangularSection({.width = 0.3, .height = 0.2, .poisson = 0.4}, 5);
  const double length = 2;
  const BeamTerm term{section, length, BeamTerm::axesOf(Vector3d::UnitX(), true)};
  const auto hessian = term.hessian(
      term.endsAt({length, 0, 0}, Eigen::Quaterniond::Identity(), Eigen::Quaterniond::Identity()));
  // Unknowns of the free end: displacement, turn.
  Eigen::Matrix<double, 6, 6> stiffness;
  stiffness << hessian.block<3, 3>(0, 0), hessian.block<3, 3>(0, 6), hessian.block<3, 3>(6, 0),
      hessian.block<3, 3>(6, 6);
  const Eigen::Matrix<double, 6, 6> flexibility = stiffness.inverse();
  const double g = 5 / (2 * 1.4), area = 0.06;
  EXPECT_NEAR(flexibility(0, 0), length / (5 * area), 1e-12);
  const auto tip = [&](double bending) {
    return std::pow(length, 3) / (3 * bending) + length / (5.0 / 6 * g * area);
  };
  EXPECT_NEAR(flexibility(1, 1), tip(5 * 0.2 * std::pow(0.3, 3) / 12), 1e-9);
  EXPECT_NEAR(flexibility(2, 2), tip(5 * 0.3 * std::pow(0.2, 3) / 12), 1e-9);
  EXPECT_NEAR(flexibility(3, 3), length / section.twisting, 1e-9);
}

/// A square's constant is 0.1406 t^4 (Timoshenko and Goodier).
TEST(BarSection, SquaresTwistAsInTextbooks) {
  const BarSection section = rectangularSection({.width = 0.5, .height = 0.5, .poisson = 0}, 2);
  EXPECT_NEAR(section.twisting, 0.1406 * std::pow(0.5, 4), 2e-3 * section.twisting);
}

/// Bars on a circle: an end moment of 2 pi EI / L closes them.
TEST(BeamTerm, SixteenOnACircleTakeTheMomentOfTheClosedForm) {
  const int pieces = 16;
  const double length = 1.0 / pieces;
  const BarSection section =
      rectangularSection({.width = 0.02, .height = 0.02, .isShearing = false}, 1);
  const BeamTerm term{section, length, BeamTerm::axesOf(Vector3d::UnitX(), true)};
  const double angle = 2 * std::numbers::pi / pieces;
  // Chords of arcs of the rest length.
  const double chord = length * std::sin(angle / 2) / (angle / 2);
  const auto ends = term.endsAt(
      {chord, 0, 0}, Eigen::Quaterniond(Eigen::AngleAxisd(-angle / 2, Vector3d::UnitZ())),
      Eigen::Quaterniond(Eigen::AngleAxisd(angle / 2, Vector3d::UnitZ())));
  const auto value = term.evaluate(ends);
  const double moment = 2 * std::numbers::pi * section.bendingN;
  EXPECT_NEAR(value.gradient.tail<1>()[0], moment, 3e-4 * moment);
  EXPECT_LT(std::abs(term.strains(ends)[0]), 2e-5);
}

}  // namespace
}  // namespace morphgrid
