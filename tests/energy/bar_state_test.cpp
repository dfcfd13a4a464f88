#include "energy/bar_state.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/solve/frame_grids.h"
#include "tests/solve/sample_grids.h"

namespace morphgrid {
namespace {

using Eigen::Vector3d;

constexpr double kWidth = 0.12;
constexpr double kHeight = 0.07;
constexpr double kAngle = 0.1;

TEST(BarState, EnergiesOfAllBarsAreTheGrids) {
  for (const bool isShearing : {false, true}) {
    const StrutGrid grid =
        welded(bentGrid({6, 4, 3}, 5),
               {.width = kWidth, .height = kHeight, .joint = 0.02, .isShearing = isShearing});
    const FramePlace place = shakenFrame(grid, 0.05, 0.2, 3);
    double sum = 0;
    forEachStrut(grid.shape, [&](const Strut& strut) {
      const BarState bar = barStateAt(grid, {place.positions, place.rotations}, strut);
      for (const double part :
           {bar.axialEnergy, bar.bendingEnergy, bar.shearEnergy, bar.twistEnergy}) {
        EXPECT_GT(part, 0);
        sum += part;
      }
    });
    const double whole = FrameEnergy(grid).evaluate(place.positions, place.rotations).energy;
    EXPECT_NEAR(sum, whole, 1e-12 * whole);
  }
}

/// One bar along x of length 1; its joints turn about an axis.
class OneBar : public testing::Test {
 protected:
  BarState turnedBy(const Vector3d& axis, double first, double second) {
    JointRotations rotations = unturnedJoints(grid_.shape.vertexCount());
    rotations.col(0) = Eigen::Quaterniond(Eigen::AngleAxisd(first, axis)).coeffs();
    rotations.col(1) = Eigen::Quaterniond(Eigen::AngleAxisd(second, axis)).coeffs();
    return barStateAt(grid_, {grid_.positions, rotations}, {0, 1, Strut::Direction::u, 0});
  }

  static StrutGrid straightBars() {
    StrutGrid grid = bentGrid({2, 2, 1}, 1);
    grid.rest.u.assign(grid.rest.u.size(), 1);
    return welded(grid, {.width = kWidth, .height = kHeight, .isShearing = false});
  }

  StrutGrid grid_ = straightBars();
};

TEST_F(OneBar, AnArcsFibresAreStrainedByTheirPlaceOverItsRadius) {
  const double curvature = 2 * kAngle;
  EXPECT_NEAR(turnedBy(Vector3d::UnitZ(), -kAngle, kAngle).bendingStrain, kWidth / 2 * curvature,
              1e-6);
  EXPECT_NEAR(turnedBy(Vector3d::UnitY(), kAngle, -kAngle).bendingStrain, kHeight / 2 * curvature,
              1e-6);
}

/// Ends that turn alike by an angle t: end moments of 6 EI t / L.
TEST_F(OneBar, AnSIsBentMostAtItsEnds) {
  const BarState bar = turnedBy(Vector3d::UnitZ(), kAngle, kAngle);
  EXPECT_NEAR(bar.bendingStrain, kWidth / 2 * 6 * kAngle, 1e-6);
  EXPECT_LT(bar.bendingEnergy, 1e-20 * bar.shearEnergy);
}

/// One end held: end moments of 4 EI t / L at the other.
TEST_F(OneBar, TurnedAtOneEndIsBentMostThere) {
  EXPECT_NEAR(turnedBy(Vector3d::UnitZ(), 0, kAngle).bendingStrain, kWidth / 2 * 4 * kAngle, 1e-6);
}

TEST_F(OneBar, BentBothWaysIsStrainedMostAlongAnEdge) {
  const Vector3d slanted = Vector3d(0, 3, 4) / 5;
  EXPECT_NEAR(turnedBy(slanted, -kAngle, kAngle).bendingStrain,
              (0.8 * kWidth + 0.6 * kHeight) / 2 * 2 * kAngle, 2e-5);
}

TEST_F(OneBar, JointRotationIsTheLargerAngleToTheChord) {
  EXPECT_NEAR(turnedBy(Vector3d::UnitZ(), kAngle, -3 * kAngle).jointRotation, 3 * kAngle, 1e-12);
  EXPECT_NEAR(turnedBy(Vector3d::UnitY(), 2 * kAngle, 0).jointRotation, 2 * kAngle, 1e-12);
}

TEST_F(OneBar, ATwistIsNoJointRotation) {
  const BarState bar = turnedBy(Vector3d::UnitX(), 0, kAngle);
  EXPECT_NEAR(bar.jointRotation, 0, 1e-12);
  EXPECT_NEAR(bar.bendingStrain, 0, 1e-12);
  EXPECT_GT(bar.twistEnergy, 0);
}

}  // namespace
}  // namespace morphgrid
