// A live session of a frame, without a window, under the validation layers.
#include "grid/bar_section.h"
#include "tests/app/live_session.h"

namespace morphgrid {
namespace {

using LiveFrame = LiveSession;

/// Where the scene leaves sizes out, knobs are at what they come to.
TEST_F(LiveFrame, BarSizesAreKnobsOfFrames) {
  folder_.write("patch.toml", kGoodPatch);
  start(kVault, {"material.model=\"frame\""});
  auto end = awaitRest();
  const ShownGrid warped = shownOf(*end, ShownStage::warped);
  EXPECT_NEAR(knob("material.bar_height"), rectangleOf(warped.grid->bars->lateral)[1], 1e-9);
  EXPECT_NEAR(knob("material.post_width"), rectangleOf(warped.grid->bars->upright)[0], 1e-9);
  session_->turnKnob("material.bar_height", "0.01");
  end = awaitRest();
  EXPECT_EQ(knob("material.bar_height"), 0.01);
  const BarSection& lateral = shownOf(*end, ShownStage::warped).grid->bars->lateral;
  EXPECT_NEAR(rectangleOf(lateral)[1], 0.01, 1e-9);
}

TEST_F(LiveFrame, AFramesJointsAreShownAsTheyHaveTurned) {
  folder_.write("patch.toml", kGoodPatch);
  start(kVault, {"material.model=\"frame\""});
  const auto end = awaitRest();
  const ShownGrid& warped = shownOf(*end, ShownStage::warped);
  ASSERT_TRUE(warped.rotations);
  const DeviceGrid& grid = *warped.onDevice;
  EXPECT_LT((grid.downloadRotations(grid.positions()) - *warped.rotations).norm(), 1e-6);
  EXPECT_GT((*warped.rotations - unturnedJoints(grid.shape().vertexCount())).norm(), 0.1);
  const ShownGrid& stacked = shownOf(*end, ShownStage::stacked);
  EXPECT_EQ(*stacked.rotations, unturnedJoints(grid.shape().vertexCount()));
  ASSERT_TRUE(end->angleErrors);
  EXPECT_EQ(end->angleErrors->size(), grid.shape().layerVertexCount());
}

}  // namespace
}  // namespace morphgrid
