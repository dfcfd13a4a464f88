#include "app/scene_text.h"

#include <gmock/gmock.h>

#include "app/scene.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;

TEST(SceneText, StandsAlone) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "base");
  std::filesystem::copy(sourceFolder() / "scenes" / "patches" / "egg_chair.toml",
                        folder / "base" / "patch.toml");
  folder.write("base/base.toml", R"(
title = "Base"
[surface]
kind = "bezier"
patch = "patch.toml"
[grid]
layer_spacing = 0.1
nodes_long = 5
)");
  const auto file = folder.write("scene.toml", R"(
extends = "base/base.toml"
[grid]
nodes_long = 6
)");
  const Scene scene = loadScene(file, {"grid.layer_spacing=0.30000000000000004"});
  EXPECT_THAT(scene.text, HasSubstr((folder / "base" / "patch.toml").string()));
  EXPECT_THAT(scene.text, testing::Not(HasSubstr("extends")));
  std::filesystem::remove(file);
  std::filesystem::remove(folder / "base" / "base.toml");
  const Scene again = loadSceneText(scene.text, folder / "elsewhere" / "state", scene.name);
  EXPECT_EQ(again.title, "Base");
  EXPECT_EQ(again.design.nodesLong, 6);
  EXPECT_EQ(again.design.layerSpacing, 0.30000000000000004);
  EXPECT_EQ(again.text, scene.text);
}

TEST(SceneText, AllScenesOfTheTreeComeBack) {
  for (const char* name : {"egg_chair_true", "face", "strip", "torso_true", "patch"}) {
    const auto file = sourceFolder() / "scenes" / (std::string(name) + ".toml");
    const Scene scene = loadScene(file);
    EXPECT_EQ(loadSceneText(scene.text, "a state", scene.name).text, scene.text) << name;
  }
}

}  // namespace
}  // namespace morphgrid
