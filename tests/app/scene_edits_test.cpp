#include "app/scene_edits.h"

#include <gmock/gmock.h>

#include <fstream>

#include "tests/app/scene_files.h"

namespace morphgrid {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

class EditedScene : public testing::Test {
 protected:
  SceneEdits edit(const std::string& name, const std::vector<std::string>& overrides = {}) const {
    return {sceneFile(folder_ / name), overrides};
  }
  std::string contentOf(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(folder_ / name).rdbuf();
    return text.str();
  }

  TemporaryFolder folder_;
};

TEST_F(EditedScene, KeysAreSetUndoneAndRedone) {
  SceneEdits edits = edit("scene.toml", {"grid.layers=3"});
  edits.set("grid.layers", "4");
  edits.set("weights.angle", "2");
  EXPECT_THAT(edits.overrides(), ElementsAre("grid.layers=4", "weights.angle=2"));
  edits.undo();
  EXPECT_THAT(edits.overrides(), ElementsAre("grid.layers=4"));
  edits.undo();
  EXPECT_THAT(edits.overrides(), ElementsAre("grid.layers=3"));
  edits.redo();
  EXPECT_THAT(edits.overrides(), ElementsAre("grid.layers=4"));
}

TEST_F(EditedScene, WithoutChangesHasNothingToUndo) {
  SceneEdits edits = edit("scene.toml");
  edits.undo();
  edits.redo();
  EXPECT_THAT(edits.overrides(), IsEmpty());
  EXPECT_FALSE(edits.canUndo());
  EXPECT_FALSE(edits.canRedo());
}

TEST_F(EditedScene, IsSavedBesideTheFileAndMeansTheSame) {
  folder_.write("p.toml", kGoodPatch);
  folder_.write("scene.toml", std::string("title = \"T\"\n") + kBezierScene);
  SceneEdits edits = edit("scene.toml", {"solver.method=jacobi"});
  edits.set("grid.layers", "5");
  const auto saved = edits.save();
  EXPECT_EQ(saved, folder_ / "scene_edited.toml");
  const Scene scene = loadScene(saved);
  EXPECT_EQ(scene.title, "T");
  EXPECT_EQ(scene.design.layers, 5);
  EXPECT_EQ(scene.design.layerSpacing, 0.1);
  EXPECT_EQ(scene.method, Method::jacobi);
  EXPECT_EQ(loadScene(folder_ / "scene.toml").design.layers, DesignRequest().layers);
}

TEST_F(EditedScene, KeepsThePathsOfABaseInAnotherFolder) {
  folder_.write("base/p.toml", kGoodPatch);
  folder_.write("base/scene.toml", kBezierScene);
  folder_.write("scene.toml", "extends = \"base/scene.toml\"\ngrid.layers = 4\n");
  SceneEdits edits = edit("scene.toml");
  edits.set("grid.layer_spacing", "0.25");
  const Scene scene = loadScene(edits.save());
  EXPECT_TRUE(std::holds_alternative<PatchRequest>(scene.surface));
  EXPECT_EQ(scene.design.layers, 4);
  EXPECT_EQ(scene.design.layerSpacing, 0.25);
}

TEST_F(EditedScene, KeepsABaseThatAnOverrideNames) {
  folder_.write("base/scene.toml", "title = \"B\"\ngrid.layers = 5\n");
  folder_.write("scene.toml", kBendAnglesScene);
  SceneEdits edits = edit("scene.toml", {"extends=base/scene.toml"});
  const Scene scene = loadScene(edits.save());
  EXPECT_EQ(scene.title, "B");
  EXPECT_EQ(scene.design.layers, 5);
}

TEST_F(EditedScene, NeverTakesThePlaceOfAFileThatWasThere) {
  folder_.write("scene.toml", "extends = \"scene_edited.toml\"\n");
  folder_.write("scene_edited.toml", kBendAnglesScene);
  SceneEdits edits = edit("scene.toml");
  edits.set("grid.nodes_u", "6");
  EXPECT_EQ(edits.save(), folder_ / "scene_edited_2.toml");
  EXPECT_EQ(contentOf("scene_edited.toml"), kBendAnglesScene);
  edits.set("grid.nodes_v", "7");
  const auto again = edits.save();
  EXPECT_EQ(again, folder_ / "scene_edited_2.toml") << "its own file is written again";
  const Scene scene = loadScene(again);
  const auto& bent = std::get<BendAngleRequest>(scene.surface);
  EXPECT_EQ(bent.nodesU, 6);
  EXPECT_EQ(bent.nodesV, 7);
}

TEST_F(EditedScene, ThatCannotBeWrittenIsTold) {
  EXPECT_THROW(edit("none.toml").save(), InputError);
}

}  // namespace
}  // namespace morphgrid
