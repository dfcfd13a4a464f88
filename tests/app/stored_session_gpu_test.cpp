// A live session that opens a finished run, without a window, under the validation layers.
#include <gmock/gmock.h>

#include "report/judge_run.h"
#include "report/report_table.h"
#include "tests/app/leave_state.h"
#include "tests/app/live_session.h"
#include "tests/support/height_field.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;

/// A session that opens a finished run.
class StoredSession : public LiveSession {
 protected:
  StoredSession() {
    folder_.write("patch.toml", kGoodPatch);
    scene_ = folder_.write("vault.toml", std::string(kVault) + "[design]\noptimise = 1\n");
    state_ = leaveState(scene_, {}, device_);
    onPost_ = [this](const auto& posted) {
      if (posted->activity == Activity::solving) solves_ = true;
    };
  }

  static bool isStored(const Snapshot& snapshot) {
    return snapshot.activity == Activity::atRest &&
           snapshot.status.find(", as stored") != std::string::npos;
  }

  std::filesystem::path state_;
  std::atomic<bool> solves_ = false;
};

TEST_F(StoredSession, ShowsAllOfTheRunWithoutSolving) {
  const RestoredRun run = restoreRun(state_);
  openStored(state_);
  const auto snapshot = awaitRest();
  EXPECT_TRUE(isStored(*snapshot)) << snapshot->status;
  EXPECT_FALSE(solves_);
  EXPECT_EQ(snapshot->title, "Vault");
  EXPECT_EQ(snapshot->figures,
            toTable(run.simulation.record) + judgeRun(run.simulation.record).line());
  EXPECT_EQ(*snapshot->targets, *run.designed.targets);
  EXPECT_FALSE(snapshot->knobs.empty());
  EXPECT_FALSE(snapshot->history.empty());
  EXPECT_EQ(snapshot->newest, ShownStage::warped);
  for (const ShownStage stage : {ShownStage::target, ShownStage::initial, ShownStage::inPlane,
                                 ShownStage::stacked, ShownStage::warped, ShownStage::surface}) {
    ASSERT_TRUE(snapshot->has(stage)) << kStageNames[static_cast<std::size_t>(stage)];
    const ShownGrid& shown = shownOf(*snapshot, stage);
    EXPECT_LT((drawnPositions(*snapshot, stage) - *shown.positions).cwiseAbs().maxCoeff(), 1e-6);
  }
  const Stage& last = run.simulation.stage;
  EXPECT_EQ(*shownOf(*snapshot, ShownStage::warped).positions, last.equilibrium.positions);
  EXPECT_EQ(shownOf(*snapshot, ShownStage::warped).grid->rest.u, last.grid.rest.u);
  EXPECT_EQ(shownOf(*snapshot, ShownStage::stacked).grid->rest.u, last.grid.rest.u);
}

TEST_F(StoredSession, IsSeenAsTheRunItselfWas) {
  openStored(state_);
  const auto stored = awaitRest();
  openStored(state_);
  session_->restart();
  const auto solved =
      await([](const Snapshot& s) { return s.activity == Activity::atRest && !isStored(s); });
  EXPECT_TRUE(solves_);
  const double spacing = shownOf(*solved, ShownStage::warped).grid->spacing;
  EXPECT_TRUE(stored->extent.isApprox(solved->extent));
  EXPECT_EQ(stored->notices, solved->notices);
  EXPECT_EQ(shownOf(*solved, ShownStage::stacked).grid->rest.u,
            shownOf(*solved, ShownStage::warped).grid->rest.u)
      << "as inverse design has left it";
  for (const ShownStage stage : {ShownStage::target, ShownStage::initial, ShownStage::inPlane,
                                 ShownStage::stacked, ShownStage::warped, ShownStage::surface}) {
    const auto place = [&](const Snapshot& s) -> Eigen::Matrix3Xd {
      return shownOf(s, stage).worldFromGrid * drawnPositions(s, stage);
    };
    EXPECT_LT((place(*stored) - place(*solved)).cwiseAbs().maxCoeff(), 1e-4 * spacing)
        << kStageNames[static_cast<std::size_t>(stage)];
  }
}

TEST_F(StoredSession, AKnobIsSolvedAndUndoBringsTheRunBack) {
  openStored(state_);
  const auto stored = awaitRest();
  std::filesystem::remove(scene_);  // The state holds it.
  session_->turnKnob("weights.angle", "2");
  const auto turned = awaitRest();
  EXPECT_FALSE(isStored(*turned));
  EXPECT_EQ(turned->title, "Vault");
  EXPECT_EQ(knob("weights.angle"), 2);
  session_->undo();
  const auto undone = awaitRest();
  EXPECT_TRUE(isStored(*undone)) << undone->status;
  EXPECT_EQ(knob("weights.angle"), 1);
  EXPECT_EQ(*shownOf(*undone, ShownStage::warped).positions,
            *shownOf(*stored, ShownStage::warped).positions);
  session_->restart();
  EXPECT_FALSE(isStored(*awaitRest()));
  session_->reload();
  EXPECT_TRUE(isStored(*awaitRest()));
}

TEST_F(StoredSession, OverridesAreSolvedAtOnce) {
  openStored(state_, {"design.optimise=0"});
  const auto snapshot = awaitRest();
  EXPECT_FALSE(isStored(*snapshot));
  EXPECT_TRUE(solves_);
}

TEST_F(StoredSession, AnotherPatchIsDesignedWhenItIsReadAgain) {
  openStored(state_);
  awaitRest();
  std::string other = kGoodPatch;
  other.replace(other.find("0.5]"), 3, "0.9");
  rewrite("patch.toml", other);
  await([](const Snapshot& s) { return s.isOutdated; });
  session_->reload();
  const auto snapshot = awaitRest();
  EXPECT_FALSE(isStored(*snapshot));
  EXPECT_FALSE(snapshot->isOutdated);
}

TEST_F(StoredSession, AnotherStateIsShownWhenItIsReadAgain) {
  openStored(state_);
  awaitRest();
  const auto time = std::filesystem::last_write_time(state_);
  leaveState(scene_, {"title=New", "design.optimise=0"}, device_);
  std::filesystem::last_write_time(state_, time + std::chrono::seconds(1));
  await([](const Snapshot& s) { return s.isOutdated; });
  session_->reload();
  const auto snapshot = awaitRest();
  EXPECT_TRUE(isStored(*snapshot));
  EXPECT_EQ(snapshot->title, "New");
  session_->turnKnob("weights.angle", "2");
  EXPECT_EQ(awaitRest()->title, "New");

  folder_.write("out/state.safetensors", "rubbish");
  session_->reload();
  EXPECT_THAT(awaitActivity(Activity::failed)->problem.value_or(""), HasSubstr("is no state"));
}

TEST_F(StoredSession, IsSavedBesideItsStateAndExported) {
  openStored(state_);
  awaitRest();
  session_->saveScene();
  awaitMessage("scene saved: " + (folder_ / "out/vault_edited.toml").string());
  session_->exportFiles();
  awaitMessage("files exported to ");
  EXPECT_TRUE(std::filesystem::exists(folder_ / "exported/warped.glb"));
}

TEST_F(StoredSession, OfASingleLayerIsShownToo) {
  state_ = leaveState(scene_, {"grid.layers=1", "design.optimise=0"}, device_);
  openStored(state_);
  const auto snapshot = awaitRest();
  EXPECT_TRUE(isStored(*snapshot));
  EXPECT_EQ(snapshot->newest, ShownStage::inPlane);
  EXPECT_FALSE(snapshot->has(ShownStage::stacked));
}

TEST_F(StoredSession, OfAMeshShowsItsSampling) {
  folder_.write("m.obj", heightFieldObj(dome));
  folder_.write("m.toml", "mesh = \"m.obj\"\nsamples_u = 21\nsamples_v = 21\n");
  const auto scene = folder_.write(
      "mesh.toml",
      "[surface]\nkind = \"mesh\"\nmesh = \"m.toml\"\nu_start = -1\nv_start = -1\nu_length = 2\n"
      "v_length = 2\n[grid]\nlayer_spacing = 0.05\nnodes_long = 8\n");
  const auto state = leaveState(scene, {}, device_);
  folder_.write("m.obj", "no mesh");  // It is not read before a knob is turned.
  openStored(state);
  const auto snapshot = awaitRest();
  EXPECT_TRUE(isStored(*snapshot));
  EXPECT_TRUE(snapshot->has(ShownStage::sampling));
  session_->turnKnob("weights.angle", "2");
  EXPECT_THAT(awaitActivity(Activity::failed)->problem.value_or(""), HasSubstr("m.obj"));
  session_->undo();
  EXPECT_TRUE(isStored(*awaitRest()));
}

}  // namespace
}  // namespace morphgrid
