#include "design/joint_loads.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "core/error.h"
#include "tests/design/stacked_grid.h"

namespace morphgrid {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::SizeIs;

constexpr double kGravity = 9.81;
constexpr double kUnit = 0.01;

/// Of 34 lateral bars of 2 and 12 posts of 1, all 0.4 thick, in cm.
MaterialRequest heavy() {
  MaterialRequest material{.model = Model::frame};
  material.gravity = {0, 0, -kGravity};
  material.density = 1200;
  material.modulus = 2e6;
  material.unit = kUnit;
  material.supports = {SupportPlace::middle};
  return material;
}

StrutGrid weldedOf(const MaterialRequest& material) {
  StrutGrid grid = stackedGridOfTwoLayers();
  applyMaterial(grid, material);
  validate(grid);
  return grid;
}

const JointLoads& loadsOf(const StrutGrid& grid) { return *grid.bars->loads; }

TEST(JointLoads, AreTheWeightOfTheBars) {
  const StrutGrid grid = weldedOf(heavy());
  const double volume = (34 * 2 + 12 * 1) * 0.4 * 0.4 * std::pow(kUnit, 3);
  EXPECT_NEAR(weightInNewtons(grid, heavy()), 1200 * volume * kGravity, 1e-12);
  EXPECT_EQ(loadsOf(grid).forces.topRows<2>().norm(), 0);
  // At a corner half of two bars and of a post.
  const double newtons = 1200 * kGravity * (2 + 2 + 1) / 2.0 * 0.4 * 0.4 * std::pow(kUnit, 3);
  const double stretchingInNewtons = 2e6 * 0.4 * 0.4 * kUnit * kUnit;
  EXPECT_NEAR(loadsOf(grid).forces(2, 0) / grid.bars->lateral.stretching,
              -newtons / stretchingInNewtons, 1e-12);
}

TEST(JointLoads, AreLessByWhatTheFluidCarries) {
  MaterialRequest inWater = heavy();
  inWater.fluidDensity = 1000;
  const StrutGrid dry = weldedOf(heavy()), wet = weldedOf(inWater);
  EXPECT_LT((6 * loadsOf(wet).forces - loadsOf(dry).forces).norm(),
            1e-12 * loadsOf(dry).forces.norm());
  inWater.fluidDensity = 1300;  // It floats, and pulls upwards.
  EXPECT_GT(loadsOf(weldedOf(inWater)).forces(2, 0), 0);
}

TEST(JointLoads, AreNoneWithoutSupports) {
  EXPECT_FALSE(weldedOf({.model = Model::frame}).bars->loads.has_value());
  MaterialRequest held{.model = Model::frame};
  held.supports = {SupportPlace::middle};
  EXPECT_EQ(loadsOf(weldedOf(held)).forces.norm(), 0);
}

TEST(JointLoads, SupportsAreJointsOfTheBottomLayerOrAnyOther) {
  const auto heldBy = [](const std::vector<Support>& supports) {
    MaterialRequest material{.model = Model::frame};
    material.supports = supports;
    return loadsOf(weldedOf(material)).held;
  };
  EXPECT_THAT(heldBy({SupportPlace::middle}), ElementsAre(4 * 1 + 2));
  EXPECT_THAT(heldBy({SupportPlace::corners}), ElementsAre(0, 3, 8, 11));
  EXPECT_THAT(heldBy({SupportPlace::rim}), SizeIs(10));
  EXPECT_THAT(heldBy({std::array{1, 2, 1}, SupportPlace::corners, std::array{0, 0, 0}}),
              ElementsAre(0, 3, 8, 11, 12 + 4 * 2 + 1));
  EXPECT_THAT(
      [&] {
        heldBy({std::array{1, 3, 0}});
      },
      testing::ThrowsMessage<InputError>(
          HasSubstr("material.supports must be joints [i, j, k] from [0, 0, 0] to [3, 2, "
                    "1], got [1, 3, 0]")));
}

TEST(JointLoads, SupportsThatKeepTheGridFromShrinkingAreTold) {
  MaterialRequest material{.model = Model::frame};
  material.supports = {std::array{1, 1, 0}, std::array{1, 1, 1}};
  EXPECT_THAT(adviseOnBars(weldedOf(material), material), IsEmpty());
  material.supports = {SupportPlace::corners};
  EXPECT_THAT(adviseOnBars(weldedOf(material), material),
              ElementsAre(HasSubstr("hold joints apart")));
  material.slide = true;
  EXPECT_THAT(adviseOnBars(weldedOf(material), material), IsEmpty());
}

TEST(JointLoads, SupportsThatSlideMustCarry) {
  MaterialRequest standing{.model = Model::frame};
  standing.slide = true;
  standing.supports = {SupportPlace::corners};
  EXPECT_TRUE(loadsOf(weldedOf(standing)).slide);
  for (const auto& other : {std::array{0, 0, 0}, std::array{2, 0, 0}, std::array{1, 0, 1}}) {
    standing.supports = {std::array{0, 0, 0}, std::array{3, 0, 0}, other};
    EXPECT_THAT([&] { weldedOf(standing); },
                testing::ThrowsMessage<InputError>(HasSubstr(
                    "material.slide needs three material.supports that are not in line")));
  }
}

}  // namespace
}  // namespace morphgrid
