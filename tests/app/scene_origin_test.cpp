#include "app/scene_origin.h"

#include <gmock/gmock.h>

#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::ElementsAre;

class SceneSources : public testing::Test {
 protected:
  std::vector<std::string> list(const std::vector<std::string>& overrides = {}) const {
    std::vector<std::string> names;
    for (const auto& file : listSceneSources(sceneFile(folder_ / "scene.toml"), overrides)) {
      names.push_back(folder_.withoutPath(file.string()));
    }
    return names;
  }

  TemporaryFolder folder_;
};

TEST_F(SceneSources, HoldWhatAPatchSceneExtends) {
  folder_.write("scene.toml", "extends = \"base/middle.toml\"\n");
  folder_.write("base/middle.toml", "extends = \"last.toml\"\n");
  folder_.write("base/last.toml", "surface.patch = \"p.toml\"\n");
  EXPECT_THAT(list(),
              ElementsAre("scene.toml", "base/middle.toml", "base/last.toml", "base/p.toml"));
  EXPECT_THAT(list({"surface.patch=q.toml"}),
              ElementsAre("scene.toml", "base/middle.toml", "base/last.toml", "q.toml"));
}

TEST_F(SceneSources, HoldTheMeshAndItsConfiguration) {
  folder_.write("scene.toml", "surface.mesh = \"meshes/m.toml\"\n");
  folder_.write("meshes/m.toml", "mesh = \"m.obj\"\n");
  folder_.write("meshes/m.obj", "");
  EXPECT_THAT(list(), ElementsAre("scene.toml", "meshes/m.toml", "meshes/m.obj"));
}

TEST_F(SceneSources, WithoutTheBaseAreAnError) {
  folder_.write("scene.toml", "extends = \"none.toml\"\n");
  EXPECT_THROW(list(), InputError);
}

}  // namespace
}  // namespace morphgrid
