// A live session without a window, under the validation layers.
#include <gmock/gmock.h>

#include <fstream>
#include <set>

#include "tests/app/live_session.h"
#include "tests/support/dome_scene.h"
#include "tests/support/height_field.h"

namespace morphgrid {
namespace {

using std::chrono_literals::operator""ms;
using testing::HasSubstr;
using testing::StartsWith;

TEST_F(LiveSession, PassesThroughAllStages) {
  folder_.write("patch.toml", kGoodPatch);
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
  folder_.write("base/patch.toml", kGoodPatch);
  folder_.write("base/base.toml", kVault);
  start("extends = \"base/base.toml\"\n");
  EXPECT_FALSE(awaitRest()->isOutdated);
  const auto isOutdated = [](const Snapshot& s) { return s.isOutdated; };
  for (const auto& [name, text] :
       {std::pair<std::string, std::string>{"base/patch.toml", kGoodPatch},
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
  folder_.write("base/patch.toml", kGoodPatch);
  folder_.write("base/base.toml", kVault);
  start("extends = \"base/base.toml\"\n");
  awaitRest();
  session_->turnKnob("grid.layers", "2");
  const std::string figures = awaitRest()->figures;
  session_->saveScene();
  awaitMessage("scene saved: ");
  scene_ = folder_ / "scene_edited.toml";
  open();
  const auto again = awaitRest();
  const auto untilTimes = [](const std::string& table) {
    return table.substr(0, table.find("in plane"));
  };
  EXPECT_EQ(untilTimes(again->figures), untilTimes(figures));
}

TEST_F(LiveSession, KeepsItsSolversWhileTheShapeOfTheGridStays) {
  const auto buffers = [](const Snapshot& s) {
    return std::pair(shownOf(s, ShownStage::inPlane).onDevice->positions().handle(),
                     shownOf(s, ShownStage::warped).onDevice->positions().handle());
  };
  start(kDomeScene);
  const auto first = awaitRest();  // Held, so that no other buffer gets its handles.
  for (const auto& [key, value] : {std::pair("weights.angle", "2"),
                                   {"grid.layer_spacing", "0.3"},
                                   {"solver.scaling", "\"shapeop\""}}) {
    session_->turnKnob(key, value);
    EXPECT_EQ(buffers(*awaitRest()), buffers(*first)) << key;
  }
  session_->restart();
  const auto kept = awaitRest();
  EXPECT_EQ(buffers(*kept), buffers(*first));
  session_->turnKnob("grid.layers", "4");
  EXPECT_NE(buffers(*awaitRest()).second, buffers(*first).second);

  open({"weights.angle=2", "grid.layer_spacing=0.3", "solver.scaling=shapeop"});
  const auto fresh = awaitRest();
  EXPECT_EQ(*shownOf(*kept, ShownStage::warped).positions,
            *shownOf(*fresh, ShownStage::warped).positions);
}

TEST_F(LiveSession, DoesNotShowTheCheckFromFlat) {
  folder_.write("patch.toml", kGoodPatch);
  std::shared_ptr<const Snapshot> checking;
  onPost_ = [&](const auto& posted) {
    if (posted->status.find("from flat") != std::string::npos) checking = posted;
  };
  scene_ = folder_.write("scene.toml", std::string(kVault) + "[design]\noptimise = 1\n");
  open();
  const auto end = awaitRest();
  ASSERT_TRUE(checking);
  EXPECT_EQ(checking->newest, ShownStage::warped);
  const double spacing = shownOf(*end, ShownStage::warped).grid->spacing;
  const Eigen::Matrix3Xd seen = drawnPositions(*checking, ShownStage::warped);
  const Eigen::Matrix3Xd rested = drawnPositions(*end, ShownStage::warped);
  EXPECT_LT((seen - rested).cwiseAbs().maxCoeff(), 1e-5 * spacing);
  EXPECT_NE(shownOf(*checking, ShownStage::warped).onDevice->positions().handle(),
            shownOf(*end, ShownStage::warped).onDevice->positions().handle())
      << "the solver's own grid would be seen to move";
  EXPECT_EQ(shownOf(*checking, ShownStage::warped).grid->rest.u,
            shownOf(*end, ShownStage::warped).grid->rest.u);
}

TEST_F(LiveSession, ExportsFiles) {
  start(kDomeScene);
  awaitRest();
  session_->exportFiles();
  awaitMessage("files exported to ");
  for (const char* file :
       {"warped.glb", "warped.vtu", "printed.vtu", "surface.ply", "surface.obj"}) {
    EXPECT_TRUE(std::filesystem::exists(folder_ / "exported" / file)) << file;
  }
}

TEST_F(LiveSession, WhereNothingCanBeWrittenSaysSo) {
  folder_.write("exported", "a file");
  start(kDomeScene);
  awaitRest();
  session_->exportFiles();
  await([](const Snapshot& s) { return s.message.find("exported") != std::string::npos; });
}

TEST_F(LiveSession, ClosesWhileItDesigns) {
  folder_.write("patch.toml", kGoodPatch);
  start(kVault, {"grid.nodes_long=1500"});  // More than half a minute.
  awaitActivity(Activity::designing);
  session_.reset();
}

TEST_F(LiveSession, AKnobTakesThePlaceOfTheDesignUnderWay) {
  folder_.write("patch.toml", kGoodPatch);
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
