#include "app/scene_knobs.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>

#include "tests/app/scene_files.h"

namespace morphgrid {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::Field;
using testing::Not;

Knob knobOf(const std::vector<Knob>& knobs, const std::string& key) {
  const auto knob =
      std::find_if(knobs.begin(), knobs.end(), [&](const Knob& k) { return k.key == key; });
  EXPECT_NE(knob, knobs.end()) << key;
  return knob == knobs.end() ? Knob{} : *knob;
}

auto withKey(const std::string& key) { return Field(&Knob::key, key); }

TEST(SceneKnobs, HaveTheScenesValues) {
  const SceneFiles files(std::string(kBezierScene) +
                         "layers = 4\nnodes_long = 9\ncurvature_cutoff = 0.75\n[weights]\nangle = "
                         "2\n[solver]\nmethod = \"jacobi\"\ntolerance = 1e-6\n");
  const auto knobs = knobsOf(files.load());
  EXPECT_EQ(knobOf(knobs, "grid.layer_spacing").value, 0.1);
  EXPECT_EQ(knobOf(knobs, "grid.layers").value, 4);
  EXPECT_EQ(knobOf(knobs, "grid.nodes_long").value, 9);
  EXPECT_EQ(knobOf(knobs, "grid.curvature_cutoff").value, 0.75);
  EXPECT_EQ(knobOf(knobs, "weights.angle").value, 2);
  EXPECT_EQ(knobOf(knobs, "solver.tolerance").value, 1e-6);
  const Knob method = knobOf(knobs, "solver.method");
  EXPECT_THAT(method.choices, ElementsAre("multigrid", "jacobi", "reference"));
  EXPECT_EQ(method.value, 1);
}

TEST(SceneKnobs, AreKeysOfTheSceneFile) {
  const SceneFiles files(kBezierScene);
  const auto known = knownSceneKeys();
  for (const Knob& knob : knobsOf(files.load())) {
    EXPECT_THAT(known, Contains(knob.key));
    EXPECT_LE(knob.low, knob.high) << knob.key;
  }
}

TEST(SceneKnobs, OfBendAnglesDesignNothing) {
  const SceneFiles files(kBendAnglesScene);
  const auto knobs = knobsOf(files.load());
  EXPECT_EQ(knobOf(knobs, "grid.layer_spacing").value, 0.1);
  EXPECT_THAT(knobs, Not(Contains(withKey("grid.nodes_long"))));
  EXPECT_THAT(knobs, Not(Contains(withKey("design.net"))));
}

TEST(SceneKnobs, OfBarsAreTheSizesThatTheSceneSays) {
  const SceneFiles files(std::string(kBezierScene) +
                         "[material]\nmodel = \"frame\"\nbar_width = 0.2\npost_width = 0.15\n");
  const auto knobs = knobsOf(files.load());
  const Knob width = knobOf(knobs, "material.bar_width");
  EXPECT_EQ(width.value, 0.2);
  EXPECT_NEAR(width.low, 0.04, 1e-12);
  EXPECT_NEAR(width.high, 1, 1e-12);
  EXPECT_EQ(knobOf(knobs, "material.post_width").value, 0.15);
  EXPECT_THAT(knobs, Not(Contains(withKey("material.bar_height"))));
}

TEST(SceneKnobs, AskForTheTrueShapeAndForItsParts) {
  const SceneFiles files(kBezierScene);
  const auto knobs = knobsOf(files.load({"true_shape=true", "design.optimise=3"}));
  for (const char* key : {"true_shape", "design.enforce_shrinkage"}) {
    const Knob knob = knobOf(knobs, key);
    EXPECT_TRUE(knob.isBoolean) << key;
    EXPECT_EQ(knob.value, 1) << key;
    EXPECT_EQ(turned(knob, "false").value, 0) << key;
    EXPECT_EQ(turned(turned(knob, "false"), "true").value, 1) << key;
    EXPECT_EQ(files.problems({std::string(key) + "=false"}), "");
  }
  EXPECT_EQ(knobOf(knobs, "design.optimise").value, 3);
}

TEST(SceneKnobs, EveryChoiceIsAValueOfTheSceneFile) {
  const SceneFiles files(kBezierScene);
  for (const Knob& knob : knobsOf(files.load())) {
    for (const std::string& choice : knob.choices) {
      EXPECT_EQ(files.problems({knob.key + "=\"" + choice + '"'}), "");
    }
  }
}

TEST(SceneKnobs, OfIntegersStayWithinWhatTheSceneFileMayHold) {
  const SceneFiles files(kBezierScene);
  const Knob layers = knobOf(knobsOf(files.load()), "grid.layers");
  EXPECT_EQ(layers.low, 1);
  EXPECT_EQ(layers.high, 64);
  for (const Knob& knob : knobsOf(files.load())) {
    if (!knob.isInteger || knob.high > 1e6) continue;  // As many nodes would be another problem.
    EXPECT_EQ(files.problems({fmt::format("{}={}", knob.key, knob.low)}), "");
    EXPECT_EQ(files.problems({fmt::format("{}={}", knob.key, knob.high)}), "");
  }
}

TEST(SceneKnobs, KeepTheirRangeWhileItHoldsTheValue) {
  const Knob old{.key = "k", .value = 1, .low = 0.2, .high = 5};
  const Knob inside{.key = "k", .value = 4, .low = 0.8, .high = 20};
  const Knob outside{.key = "k", .value = 6, .low = 1.2, .high = 30};
  EXPECT_EQ(keepRanges({inside}, {old}).front().high, 5);
  EXPECT_EQ(keepRanges({outside}, {old}).front().high, 30);
  EXPECT_EQ(keepRanges({inside}, {}).front().high, 20);
}

TEST(SceneKnobs, AreTurnedByWhatGoesIntoTheFile) {
  EXPECT_EQ(turned({.value = 1}, "2.5").value, 2.5);
  EXPECT_EQ(turned({.value = 1}, "nonsense").value, 1);
  const Knob choice{.value = 0, .choices = {"a", "b"}};
  EXPECT_EQ(turned(choice, "\"b\"").value, 1);
  EXPECT_EQ(turned(choice, "\"c\"").value, 0);
}

}  // namespace
}  // namespace morphgrid
