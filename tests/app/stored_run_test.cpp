// Runs that a state keeps. The oracle's method needs no device.
#include "app/stored_run.h"

#include <gmock/gmock.h>

#include "app/scene_edits.h"
#include "tests/app/leave_state.h"
#include "tests/app/scene_files.h"

namespace morphgrid {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

class StoredRunTest : public testing::Test {
 protected:
  StoredRunTest() {
    folder_.write("p.toml", kGoodPatch);
    folder_.write("vault.toml", std::string(kBezierScene) + "layers = 2\nnodes_long = 3\n");
  }

  std::filesystem::path leave(const std::string& override = "title=T") const {
    return leaveState(folder_ / "vault.toml", {"solver.method=reference", override});
  }
  /// As if it had been written a while later.
  void age(const std::filesystem::path& file) const {
    const auto time = std::filesystem::last_write_time(file);
    std::filesystem::last_write_time(file, time + std::chrono::seconds(++seconds_));
  }

  TemporaryFolder folder_;
  mutable int seconds_ = 0;
};

TEST_F(StoredRunTest, KeepsItsScene) {
  const StoredRun stored(leave());
  std::filesystem::remove(folder_ / "vault.toml");
  const Scene scene = loadScene(stored.origin(), {});
  EXPECT_EQ(scene.name, "vault");
  EXPECT_EQ(scene.title, "T");
  EXPECT_EQ(scene.method, Method::reference);
  EXPECT_EQ(scene.design.layers, 2);
  EXPECT_EQ(std::get<PatchRequest>(scene.surface).file, folder_ / "p.toml");
  EXPECT_EQ(loadScene(stored.origin(), {"grid.layers=3"}).design.layers, 3);
  EXPECT_THAT([&] { loadScene(stored.origin(), {"grid.layers=0"}); },
              ThrowsMessage<InputError>(HasSubstr("grid.layers must be an integer >= 1")));
}

TEST_F(StoredRunTest, WithoutATitleHasItsName) {
  const StoredRun stored(leave("grid.layers=2"));
  EXPECT_EQ(stored.run().scene.title, "vault");
}

TEST_F(StoredRunTest, IsReadFromItsStateAndItsTarget) {
  const auto state = leave();
  EXPECT_THAT(listSceneSources(StoredRun(state).origin(), {}),
              ElementsAre(state, folder_ / "p.toml"));
}

TEST_F(StoredRunTest, IsOfItsSceneUntilSomethingChanges) {
  const StoredRun stored(leave());
  EXPECT_TRUE(stored.isOf({}));
  EXPECT_FALSE(stored.isOf({"grid.layers=2"}));
  age(folder_ / "vault.toml");  // The state holds it.
  EXPECT_TRUE(stored.isOf({}));
  age(folder_ / "p.toml");
  EXPECT_FALSE(stored.isOf({}));
}

TEST_F(StoredRunTest, IsReadAgainWhereItsStateHasChanged) {
  const auto state = leave();
  StoredRun stored(state);
  EXPECT_FALSE(stored.refresh());
  age(folder_ / "p.toml");
  leave("title=Other");
  age(state);
  EXPECT_TRUE(stored.refresh());
  EXPECT_EQ(stored.run().scene.title, "Other");
  EXPECT_TRUE(stored.isOf({})) << "it has been solved with the patch as it is";
  EXPECT_FALSE(stored.refresh());
}

TEST_F(StoredRunTest, StaysWhereItsStateBreaks) {
  const auto state = leave();
  StoredRun stored(state);
  folder_.write("out/state.safetensors", "rubbish");
  age(state);
  EXPECT_THAT([&] { stored.refresh(); }, ThrowsMessage<InputError>(HasSubstr("is no state")));
  EXPECT_EQ(stored.run().scene.title, "T");
  EXPECT_THROW(StoredRun{state}, InputError);
}

TEST_F(StoredRunTest, IsSavedBesideItsState) {
  SceneEdits edits(StoredRun(leave()).origin(), {});
  edits.set("grid.layers", "4");
  const auto saved = edits.save();
  EXPECT_EQ(saved, folder_ / "out/vault_edited.toml");
  const Scene scene = loadScene(saved);
  EXPECT_EQ(scene.design.layers, 4);
  EXPECT_EQ(scene.title, "T");
  EXPECT_EQ(std::get<PatchRequest>(scene.surface).file, folder_ / "p.toml");
}

}  // namespace
}  // namespace morphgrid
