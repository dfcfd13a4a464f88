// A live session without a window, under the validation layers.
#include "app/live_run.h"

#include <gmock/gmock.h>

#include <fstream>
#include <set>

#include "core/error.h"
#include "tests/support/dome_scene.h"
#include "tests/support/height_field.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using std::chrono_literals::operator""ms;
using std::chrono_literals::operator""s;
using testing::Contains;
using testing::HasSubstr;
using testing::StartsWith;

constexpr const char* kVault = R"(
title = "Vault"
[surface]
kind = "bezier"
patch = "patch.toml"
[grid]
layers = 3
layer_spacing = 0.1
nodes_long = 6
)";

constexpr const char* kPatch = R"(control_points = [
  [[0, 0, 0], [1, 0, 1], [2, 0, 1], [3, 0, 0]],
  [[0, 1, 0], [1, 1, 1], [2, 1, 1], [3, 1, 0]],
  [[0, 2, 0], [1, 2, 1], [2, 2, 1], [3, 2, 0]],
  [[0, 3, 0], [1, 3, 1], [2, 3, 1], [3, 3, 0.5]],
]
)";

class LiveSession : public testing::Test {
 protected:
  using Condition = std::function<bool(const Snapshot&)>;

  void start(const std::string& scene, const std::vector<std::string>& overrides = {}) {
    scene_ = folder_.write("scene.toml", scene);
    open(overrides);
  }
  void open(const std::vector<std::string>& overrides = {}) {
    session_ = std::make_unique<LiveRun>(device_, LiveRunOptions{scene_, overrides, folder_ / "out",
                                                                 [this] { wakes_.notify_all(); }});
    session_->showEveryStep(false);
  }
  void TearDown() override {
    session_.reset();
    for (const std::string& message : device_->validationMessages()) {
      ADD_FAILURE() << message;
    }
  }

  /// The first snapshot for which the condition holds; the last one when none comes.
  std::shared_ptr<const Snapshot> await(const Condition& condition) {
    std::unique_lock lock(mutex_);
    const auto end = std::chrono::steady_clock::now() + 60s;
    auto snapshot = session_->snapshot();
    while (!condition(*snapshot) && std::chrono::steady_clock::now() < end) {
      wakes_.wait_for(lock, 5ms);
      snapshot = session_->snapshot();
    }
    EXPECT_TRUE(condition(*snapshot)) << snapshot->status << snapshot->problem.value_or("");
    return snapshot;
  }
  std::shared_ptr<const Snapshot> awaitActivity(Activity activity) {
    return await([&](const Snapshot& s) { return s.activity == activity; });
  }
  /// At rest after another design than the last one that was awaited.
  std::shared_ptr<const Snapshot> awaitRest() {
    auto snapshot =
        await([&](const Snapshot& s) { return s.activity == Activity::atRest && s.runs > runs_; });
    runs_ = snapshot->runs;
    return snapshot;
  }
  std::shared_ptr<const Snapshot> awaitMessage(const std::string& start) {
    return await([&](const Snapshot& s) { return s.message.rfind(start, 0) == 0; });
  }
  double knob(const std::string& key) const {
    for (const Knob& knob : session_->snapshot()->knobs) {
      if (knob.key == key) return knob.value;
    }
    ADD_FAILURE() << key;
    return 0;
  }
  /// Changes a file so that its time tells.
  void rewrite(const std::string& name, const std::string& text) {
    const auto file = folder_ / name;
    const auto before = std::filesystem::last_write_time(file);
    folder_.write(name, text);
    std::filesystem::last_write_time(file, before + 1s);
  }

  TemporaryFolder folder_;
  std::shared_ptr<Device> device_ =
      std::make_shared<Device>(DeviceOptions{.selection = "", .validation = true});
  std::filesystem::path scene_;
  std::mutex mutex_;
  std::condition_variable wakes_;
  long runs_ = 0;
  std::unique_ptr<LiveRun> session_;
};

TEST_F(LiveSession, PassesThroughAllStages) {
  folder_.write("patch.toml", kPatch);
  start(kVault);
  const auto end = awaitRest();
  EXPECT_EQ(end->title, "Vault");
  EXPECT_THAT(end->status, StartsWith("at rest after "));
  EXPECT_THAT(end->status, HasSubstr("(converged)"));
  for (const ShownStage stage : {ShownStage::target, ShownStage::initial, ShownStage::inPlane,
                                 ShownStage::stacked, ShownStage::warped, ShownStage::surface}) {
    ASSERT_TRUE(end->has(stage)) << kStageNames[static_cast<std::size_t>(stage)];
    EXPECT_TRUE(end->stages[static_cast<std::size_t>(stage)]->onDevice);
  }
  EXPECT_FALSE(end->has(ShownStage::sampling));
  EXPECT_EQ(end->newest, ShownStage::warped);
  EXPECT_EQ(end->targets->cols(), 7 * 7);
  EXPECT_EQ(end->strutCount, end->stages[5]->grid->shape.strutCount());
  EXPECT_FALSE(end->history.empty());
  EXPECT_THAT(end->figures, HasSubstr("distance"));
  EXPECT_FALSE(end->isOutdated);
}

TEST_F(LiveSession, PausesAndDoesSingleSteps) {
  start(kDomeScene);
  session_->pause(true);
  auto snapshot = awaitActivity(Activity::paused);
  const auto samples = snapshot->history.size();
  const auto status = snapshot->status;
  session_->step();
  await([&](const Snapshot& s) { return s.history.size() != samples || s.status != status; });
  awaitActivity(Activity::paused);
  session_->pause(false);
  awaitRest();
}

/// 3 x vertexCount, as frames draw them.
Eigen::Matrix3Xd drawnPositions(const Snapshot& snapshot, ShownStage stage) {
  const DeviceGrid& grid = *snapshot.stages[static_cast<std::size_t>(stage)]->onDevice;
  return grid.downloadPositions(grid.positions());
}

TEST_F(LiveSession, ShowsStepsOfTheMethodThatKeepsPositionsOnTheHost) {
  start(kDomeScene, {"solver.method=\"reference\""});
  session_->pause(true);
  const auto hasMoved = [](const Snapshot& s) {
    return s.newest == ShownStage::warped && s.activity == Activity::paused &&
           drawnPositions(s, ShownStage::warped) != drawnPositions(s, ShownStage::stacked);
  };
  auto snapshot = awaitActivity(Activity::paused);
  for (int n = 0; n < 100 && !hasMoved(*snapshot); ++n) {
    session_->step();
    snapshot = await([&](const Snapshot& s) {
      return s.status != snapshot->status && s.activity != Activity::solving;
    });
  }
  EXPECT_TRUE(hasMoved(*snapshot)) << snapshot->status;
}

TEST_F(LiveSession, AKnobTakesThePlaceOfTheSolveUnderWay) {
  start(kDomeScene);
  session_->pause(true);
  awaitActivity(Activity::paused);
  session_->pause(false);
  session_->turnKnob("grid.layers", "4");
  const auto end = awaitRest();
  EXPECT_EQ(knob("grid.layers"), 4);
  EXPECT_EQ(end->stages[static_cast<std::size_t>(ShownStage::warped)]->grid->shape.layers, 4);
  EXPECT_TRUE(end->canUndo);
  EXPECT_FALSE(end->canRedo);
}

TEST_F(LiveSession, AKnobKeepsTheTargetThatItLeavesAsItIs) {
  folder_.write("m.obj", heightFieldObj(dome));
  folder_.write("m.toml", "mesh = \"m.obj\"\nsamples_u = 21\nsamples_v = 21\n");
  start(
      "[surface]\nkind = \"mesh\"\nmesh = \"m.toml\"\nu_start = -1\nv_start = -1\nu_length = 2\n"
      "v_length = 2\n[grid]\nlayer_spacing = 0.05\nnodes_long = 8\n");
  const auto sampling = awaitRest()->sampling;  // A part of the target.
  ASSERT_TRUE(sampling);
  for (const char* key : {"grid.layers", "grid.nodes_long"}) {
    session_->turnKnob(key, "4");
    EXPECT_EQ(awaitRest()->sampling, sampling) << key;
  }
  session_->turnKnob("surface.smoothing_width", "0.2");
  EXPECT_NE(awaitRest()->sampling, sampling);
}

TEST_F(LiveSession, KnobsAreUndoneAndRedone) {
  start(kDomeScene);
  awaitRest();
  session_->turnKnob("weights.angle", "2");
  awaitRest();
  session_->undo();
  EXPECT_TRUE(awaitRest()->canRedo);
  EXPECT_EQ(knob("weights.angle"), 1);
  session_->undo();  // There is nothing left.
  awaitRest();
  session_->redo();
  awaitRest();
  EXPECT_EQ(knob("weights.angle"), 2);
}

TEST_F(LiveSession, ABadValueIsToldAndUndone) {
  start(kDomeScene);
  awaitRest();
  session_->turnKnob("grid.layers", "0");
  const auto failed = awaitActivity(Activity::failed);
  EXPECT_THAT(failed->problem.value_or(""),
              HasSubstr("grid.layers must be an integer >= 1 and <= 64, got 0"));
  session_->exportFiles();
  awaitMessage("there is no result to export yet");
  session_->undo();
  EXPECT_EQ(awaitRest()->problem, std::nullopt);
  EXPECT_EQ(knob("grid.layers"), 3);
}

TEST_F(LiveSession, SolvesByEveryMethod) {
  start(kDomeScene);
  const auto byMultigrid = awaitRest();
  const auto warped = [](const Snapshot& s) {
    return *s.stages[static_cast<std::size_t>(ShownStage::warped)];
  };
  const double spacing = warped(*byMultigrid).grid->spacing;
  for (const char* method : {"\"jacobi\"", "\"reference\""}) {
    session_->turnKnob("solver.method", method);
    const auto end = awaitRest();
    EXPECT_THAT(end->status, HasSubstr("(converged)")) << method;
    const auto place = [&](const Snapshot& s) -> Eigen::Matrix3Xd {
      return warped(s).worldFromGrid * *warped(s).positions;
    };
    EXPECT_LT((place(*end) - place(*byMultigrid)).colwise().norm().maxCoeff(), 0.01 * spacing)
        << method;
  }
}

TEST_F(LiveSession, TellsOfChangesOnDiskAndReadsThem) {
  folder_.write("base/patch.toml", kPatch);
  folder_.write("base/base.toml", kVault);
  start("extends = \"base/base.toml\"\n");
  EXPECT_FALSE(awaitRest()->isOutdated);
  const auto isOutdated = [](const Snapshot& s) { return s.isOutdated; };
  for (const auto& [name, text] :
       {std::pair<std::string, std::string>{"base/patch.toml", kPatch},
        {"base/base.toml", std::string(kVault) + "max_shrinkage = 0.5\n"},
        {"scene.toml", "title = \"New\"\nextends = \"base/base.toml\"\n"}}) {
    rewrite(name, text);
    await(isOutdated);
    session_->reload();
    EXPECT_FALSE(awaitRest()->isOutdated) << name;
  }
  EXPECT_EQ(session_->snapshot()->title, "New");
  EXPECT_EQ(knob("grid.max_shrinkage"), 0.5);
}

TEST_F(LiveSession, TellsOfChangesOnDiskWhilePaused) {
  start(kDomeScene);
  session_->pause(true);
  awaitActivity(Activity::paused);
  rewrite("scene.toml", kDomeScene);
  await([](const Snapshot& s) { return s.isOutdated; });
}

TEST_F(LiveSession, AFileThatBreaksIsToldAndMended) {
  start(kDomeScene);
  awaitRest();
  rewrite("scene.toml", "title = ");
  session_->reload();
  EXPECT_THAT(awaitActivity(Activity::failed)->problem.value_or(""), HasSubstr("not valid TOML"));
  rewrite("scene.toml", kDomeScene);
  await([](const Snapshot& s) { return s.isOutdated; });
  session_->reload();
  awaitRest();
}

TEST_F(LiveSession, TheSceneThatItSavesMeansTheSame) {
  folder_.write("base/patch.toml", kPatch);
  folder_.write("base/base.toml", kVault);
  start("extends = \"base/base.toml\"\n");
  awaitRest();
  session_->turnKnob("grid.layers", "2");
  const std::string figures = awaitRest()->figures;
  session_->saveScene();
  awaitMessage("scene saved: ");
  session_.reset();
  scene_ = folder_ / "scene_edited.toml";
  runs_ = 0;
  open();
  const auto again = awaitRest();
  const auto untilTimes = [](const std::string& table) {
    return table.substr(0, table.find("in plane"));
  };
  EXPECT_EQ(untilTimes(again->figures), untilTimes(figures));
}

TEST_F(LiveSession, ExportsFiles) {
  start(kDomeScene);
  awaitRest();
  session_->exportFiles();
  awaitMessage("files exported to ");
  for (const char* file : {"warped.glb", "warped.vtu", "surface.ply", "surface.obj"}) {
    EXPECT_TRUE(std::filesystem::exists(folder_ / "out" / file)) << file;
  }
}

TEST_F(LiveSession, WhereNothingCanBeWrittenSaysSo) {
  folder_.write("out", "a file");
  start(kDomeScene);
  awaitRest();
  session_->exportFiles();
  await([](const Snapshot& s) { return s.message.find("out") != std::string::npos; });
}

TEST_F(LiveSession, ClosesWhileItDesigns) {
  folder_.write("patch.toml", kPatch);
  start(kVault, {"grid.nodes_long=1500"});  // More than half a minute.
  awaitActivity(Activity::designing);
  session_.reset();
}

TEST_F(LiveSession, AKnobTakesThePlaceOfTheDesignUnderWay) {
  folder_.write("patch.toml", kPatch);
  start(kVault, {"grid.nodes_long=1500"});
  await([](const Snapshot& s) { return !s.knobs.empty(); });
  session_->turnKnob("grid.nodes_long", "6");
  EXPECT_EQ(awaitRest()->targets->cols(), 7 * 7);
}

TEST_F(LiveSession, ClosesWhileItSolvesOrIsPaused) {
  for (const bool isPaused : {false, true}) {
    start(kDomeScene, {"grid.nodes_u=60", "grid.nodes_v=60"});
    session_->pause(isPaused);
    awaitActivity(isPaused ? Activity::paused : Activity::solving);
    session_.reset();
  }
}

TEST_F(LiveSession, WaitsForFramesWhereEveryStepIsShown) {
  start(kDomeScene);
  session_->showEveryStep(true);
  session_->restart();
  for (long frame = 0; frame < 10000; ++frame) {
    session_->noteFrame();
    if (session_->snapshot()->activity == Activity::atRest) break;
    std::this_thread::sleep_for(1ms);
  }
  awaitRest();
}

}  // namespace
}  // namespace morphgrid
