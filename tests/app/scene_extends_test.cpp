#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/app/scene_files.h"

namespace morphgrid {
namespace {

/// A folder base/ with scene.toml and its patch, and files beside it that extend that.
class ExtendedScene : public testing::Test {
 protected:
  ExtendedScene() {
    folder_.write("base/scene.toml", std::string(kBezierScene) + "layers = 5\n");
    folder_.write("base/p.toml", kGoodPatch);
  }

  Scene load(const std::string& text, const std::vector<std::string>& overrides = {}) const {
    return loadScene(folder_.write("new.toml", text), overrides);
  }

  std::string problems(const std::string& text,
                       const std::vector<std::string>& overrides = {}) const {
    try {
      load(text, overrides);
    } catch (const InputError& error) {
      return folder_.withoutPath(error.what());
    }
    return "";
  }

  TemporaryFolder folder_;
};

TEST_F(ExtendedScene, GivesWhatTheFileLeavesOut) {
  const Scene scene = load("extends = \"base/scene.toml\"\n[grid]\nlayer_spacing = 0.2\n");
  EXPECT_EQ(scene.name, "new");
  EXPECT_EQ(scene.title, "new");
  EXPECT_EQ(scene.design.layers, 5);
  EXPECT_EQ(scene.design.layerSpacing, 0.2);
  EXPECT_TRUE(std::holds_alternative<PatchRequest>(scene.surface));
}

TEST_F(ExtendedScene, MayExtendAThirdFile) {
  folder_.write("base/middle.toml", "extends = \"scene.toml\"\ntitle = \"M\"\ngrid.layers = 4\n");
  const Scene scene = load("extends = \"base/middle.toml\"\n");
  EXPECT_EQ(scene.title, "M");
  EXPECT_EQ(scene.design.layers, 4);
}

TEST_F(ExtendedScene, PathsAreRelativeToTheFileThatHoldsThem) {
  folder_.write("p.toml", kGoodPatch);
  EXPECT_EQ(problems("extends = \"base/scene.toml\"\nsurface.patch = \"p.toml\"\n"), "");
  EXPECT_EQ(problems("extends = \"base/scene.toml\"\n", {"surface.patch=p.toml"}), "");
  EXPECT_EQ(problems("extends = \"base/scene.toml\"\nsurface.patch = \"q.toml\"\n"),
            "new.toml:2:17: surface.patch must name a readable file, got q.toml: No such file or "
            "directory");
}

TEST_F(ExtendedScene, OverridesCountMost) {
  EXPECT_EQ(
      load("extends = \"base/scene.toml\"\ngrid.layers = 4\n", {"grid.layers=3"}).design.layers, 3);
  EXPECT_EQ(
      load(kBezierScene, {"extends=base/scene.toml", "surface.patch=base/p.toml"}).design.layers,
      5);
}

TEST_F(ExtendedScene, ProblemsNameTheFileThatTheyAreIn) {
  folder_.write("base/scene.toml", std::string(kBezierScene) + "layers = 65\nlayrs = 4\n");
  EXPECT_EQ(
      problems("extends = \"base/scene.toml\"\n\n[grid]\nnodes_lnog = 3\n", {"grid.nodes_long=0"}),
      "base/scene.toml:6:10: grid.layers must be an integer >= 1 and <= 64, got 65\n"
      "base/scene.toml:7:1: unknown key grid.layrs; did you mean grid.layers?\n"
      "new.toml:4:1: unknown key grid.nodes_lnog; did you mean grid.nodes_long?\n"
      "--set grid.nodes_long=0: grid.nodes_long must be an integer >= 1 and <= 2147483647, "
      "got 0");
  folder_.write("base/scene.toml", "grid = 3 4\n");
  EXPECT_THAT(problems("extends = \"base/scene.toml\"\n"),
              testing::StartsWith("base/scene.toml:1:10: not valid TOML: "));
}

TEST_F(ExtendedScene, MustNameAFile) {
  EXPECT_EQ(problems(std::string("extends = \"none.toml\"\n") + kBezierScene),
            "new.toml:1:11: extends must name a readable file, got none.toml: No such file or "
            "directory");
  EXPECT_THAT(problems(std::string("extends = 3\n") + kBezierScene),
              testing::HasSubstr("new.toml:1:11: extends must be a string, got 3"));
  EXPECT_EQ(problems(kBezierScene, {"extends=none.toml"}),
            "--set extends=none.toml: extends must name a readable file, got none.toml: No such "
            "file or directory");
}

TEST_F(ExtendedScene, MustNotExtendItself) {
  EXPECT_EQ(problems("extends = \"./new.toml\"\n"),
            "new.toml:1:11: extends must not lead back to new.toml");
  folder_.write("base/scene.toml", "title = \"B\"\nextends = \"../new.toml\"\n");
  EXPECT_EQ(problems("extends = \"base/scene.toml\"\n"),
            "base/scene.toml:2:11: extends must not lead back to new.toml");
}

TEST_F(ExtendedScene, IsForScenesOnly) {
  folder_.write("base/q.toml", "extends = \"p.toml\"\n");
  EXPECT_THAT(problems("extends = \"base/scene.toml\"\n", {"surface.patch=base/q.toml"}),
              testing::HasSubstr("base/q.toml:1:1: unknown key extends"));
}

}  // namespace
}  // namespace morphgrid
