#include "energy/strut_energy.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <random>

#include "tests/solve/sample_grids.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

class EnergyOfShapes : public testing::TestWithParam<GridShape> {};

TEST_P(EnergyOfShapes, GradientAgreesWithFiniteDifferences) {
  const StrutGrid grid = bentGrid(GetParam(), 3);
  const StrutEnergy energy(grid);
  const Matrix3Xd x = shaken(grid.positions, 0.1, 5);
  const Matrix3Xd gradient = energy.evaluate(x).gradient;
  constexpr double h = 1e-6;
  for (Eigen::Index n = 0; n < x.cols(); n += 3) {
    for (int axis = 0; axis < 3; ++axis) {
      Matrix3Xd before = x;
      Matrix3Xd after = x;
      before(axis, n) -= h;
      after(axis, n) += h;
      const double expected =
          (energy.evaluate(after).energy - energy.evaluate(before).energy) / (2 * h);
      EXPECT_NEAR(gradient(axis, n), expected, 1e-6 * (1 + std::abs(expected)));
    }
  }
}

TEST_P(EnergyOfShapes, RigidMotionChangesNothing) {
  const StrutGrid grid = bentGrid(GetParam(), 4);
  const StrutEnergy energy(grid);
  const Matrix3Xd x = shaken(grid.positions, 0.1, 6);
  const Eigen::Isometry3d motion =
      Eigen::Translation3d(3, -2, 9) * Eigen::AngleAxisd(2.1, Vector3d(1, -1, 0.3).normalized());
  const auto here = energy.evaluate(x);
  const auto there = energy.evaluate(motion * x);
  EXPECT_NEAR(there.energy, here.energy, 1e-12 * here.energy);
  EXPECT_LT((there.gradient - motion.linear() * here.gradient).norm(),
            1e-11 * here.gradient.norm());
  // No net force, no net torque.
  EXPECT_LT(here.gradient.rowwise().sum().norm(), 1e-11 * here.gradient.norm());
  Vector3d torque = Vector3d::Zero();
  for (Eigen::Index n = 0; n < x.cols(); ++n) {
    torque += x.col(n).cross(here.gradient.col(n));
  }
  EXPECT_LT(torque.norm(), 1e-10 * here.gradient.norm());
}

INSTANTIATE_TEST_SUITE_P(Shapes, EnergyOfShapes,
                         testing::Values(GridShape{2, 2, 1}, GridShape{5, 3, 1}, GridShape{2, 2, 2},
                                         GridShape{4, 5, 3}));

/// Smallest |a-p|^2 + |b-q|^2 with p . q = 0, by searching the direction of p and projecting.
double bruteForceCorner(const Vector3d& a, const Vector3d& b) {
  // The nearest p, q lie in the plane of a and b; p along a unit vector d, q along its normal
  // there.
  const Vector3d x = a.normalized();
  const Vector3d y = (b - b.dot(x) * x).normalized();
  double best = 1e300;
  constexpr int kSteps = 200000;
  for (int n = 0; n < kSteps; ++n) {
    const double t = M_PI * n / kSteps;
    const Vector3d d = std::cos(t) * x + std::sin(t) * y;
    const Vector3d e = -std::sin(t) * x + std::cos(t) * y;
    best = std::min(best, (a - a.dot(d) * d).squaredNorm() + (b - b.dot(e) * e).squaredNorm());
  }
  return best;
}

TEST(StrutEnergy, CornerIsTheDistanceToTheNearestRightAngle) {
  std::mt19937 random(2);
  std::normal_distribution<double> coordinate;
  for (int trial = 0; trial < 10; ++trial) {
    // One square cell with three corners right and struts at rest would hide the fourth: so compare
    // the closed form itself.
    const Vector3d a(coordinate(random), coordinate(random), coordinate(random));
    const Vector3d b(coordinate(random), coordinate(random), coordinate(random));
    const double t = a.squaredNorm() + b.squaredNorm();
    const double s = a.dot(b);
    const double closedForm = 2 * s * s / (t + std::sqrt(t * t - 4 * s * s));
    EXPECT_NEAR(bruteForceCorner(a, b), closedForm, 1e-8 * t);
  }
}

TEST(StrutEnergy, OneCellAddsItsFourCorners) {
  StrutGrid grid = bentGrid({2, 2, 1}, 0);
  const Vector3d corners[4] = {{0, 0, 0}, {1.2, 0.1, 0}, {-0.2, 0.9, 0.1}, {1.1, 1.3, -0.2}};
  for (int n = 0; n < 4; ++n) {
    grid.positions.col(n) = corners[n];
  }
  double expected = 0;
  const int neighbours[4][2] = {{1, 2}, {0, 3}, {3, 0}, {2, 1}};
  for (int n = 0; n < 4; ++n) {
    expected += bruteForceCorner(corners[neighbours[n][0]] - corners[n],
                                 corners[neighbours[n][1]] - corners[n]);
  }
  forEachStrut(grid.shape, [&](const Strut& strut) {
    valueAt(grid.rest, strut) = (corners[strut.to] - corners[strut.from]).norm();
  });
  EXPECT_NEAR(StrutEnergy(grid).evaluate(grid.positions).energy, expected, 1e-8);
}

TEST(StrutEnergy, CollinearArmsStayFinite) {
  StrutGrid grid = bentGrid({2, 2, 1}, 0);
  grid.positions.col(3) = Vector3d(3, 0, 0);
  grid.positions.col(2) = Vector3d(2, 0, 0);
  const auto value = StrutEnergy(grid).evaluate(grid.positions);
  EXPECT_TRUE(std::isfinite(value.energy));
  EXPECT_TRUE(value.gradient.allFinite());
}

TEST(StrutEnergy, ResidualDoesNotDependOnUnits) {
  const StrutGrid grid = bentGrid({4, 3, 2}, 1);
  StrutGrid scaled = grid;
  scaled.spacing *= 1000;
  scaled.positions *= 1000;
  for (auto* values : {&scaled.rest.u, &scaled.rest.v, &scaled.rest.w}) {
    for (double& rest : *values) {
      rest *= 1000;
    }
  }
  const StrutEnergy energy(grid);
  const StrutEnergy scaledEnergy(scaled);
  const double residual = energy.residual(energy.evaluate(grid.positions).gradient);
  EXPECT_GT(residual, 0);
  EXPECT_NEAR(scaledEnergy.residual(scaledEnergy.evaluate(scaled.positions).gradient) / residual, 1,
              1e-12);
}

}  // namespace
}  // namespace morphgrid
