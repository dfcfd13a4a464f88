#include "view/detail_governor.h"

#include <gtest/gtest.h>

namespace morphgrid {
namespace {

constexpr GridShape kSmall{9, 11, 3};
constexpr GridShape kMedium{18, 21, 3};
constexpr GridShape kHuge{380, 440, 3};
const Detail kFinest{StrutStyle::tubes, 4, 1};

void showFrames(DetailGovernor& governor, int count, double seconds) {
  for (int n = 0; n < count; ++n) {
    governor.update(seconds);
  }
}

TEST(DetailGovernor, DrawsFewStrutsAsFineAsItCan) {
  EXPECT_EQ(DetailGovernor(kSmall).detail(), kFinest);
}

TEST(DetailGovernor, DrawsThousandsOfStrutsAsRibbonsAndThemAsTubesWhereTheyStay) {
  const DetailGovernor governor(kMedium);
  EXPECT_EQ(governor.detail(), (Detail{StrutStyle::ribbons, 4, 1}));
  EXPECT_EQ(governor.still(), kFinest);
}

TEST(DetailGovernor, KnowsThatBarsTakeLongerThanTubes) {
  DetailGovernor governor(kSmall);
  governor.begin({11, 11, 3});
  EXPECT_EQ(governor.detail(), kFinest);
  governor.begin({11, 11, 3}, /*isFrame=*/true);
  EXPECT_EQ(governor.detail().style, StrutStyle::ribbons);
}

TEST(DetailGovernor, DrawsAMillionStrutsAsFewLines) {
  const Detail detail = DetailGovernor(kHuge).detail();
  EXPECT_EQ(detail.style, StrutStyle::lines);
  EXPECT_GE(detail.stride, 4);
}

TEST(DetailGovernor, KeepsALevelWhoseFramesAreInTime) {
  DetailGovernor governor(kSmall);
  showFrames(governor, 200, 0.02);
  EXPECT_EQ(governor.detail(), kFinest);
}

TEST(DetailGovernor, GoesDownFromTubesToRibbonsWhereFramesAreLate) {
  DetailGovernor governor(kSmall);
  showFrames(governor, 6, 0.2);
  EXPECT_EQ(governor.detail(), (Detail{StrutStyle::ribbons, 4, 1}));
}

TEST(DetailGovernor, GoesDownLevelByLevelWhereFramesAreLate) {
  DetailGovernor governor(kMedium);
  showFrames(governor, 6, 0.2);
  EXPECT_EQ(governor.detail(), (Detail{StrutStyle::ribbons, 1, 1}));
  showFrames(governor, 6, 0.2);
  EXPECT_EQ(governor.detail(), (Detail{StrutStyle::lines, 1, 1}));
  showFrames(governor, 100, 0.2);
  const int coarsest = governor.detail().stride;
  EXPECT_GT(coarsest, 1);
  showFrames(governor, 1000, 0.2);
  EXPECT_EQ(governor.detail().stride, coarsest) << "a few lines must remain";
}

TEST(DetailGovernor, ForgivesASingleLateFrame) {
  DetailGovernor governor(kSmall);
  showFrames(governor, 20, 0.01);
  governor.update(0.1);
  EXPECT_EQ(governor.detail(), kFinest);
}

TEST(DetailGovernor, ComesBackWhenThereIsTime) {
  DetailGovernor governor(kSmall);
  showFrames(governor, 40, 0.2);
  ASSERT_EQ(governor.detail(), (Detail{StrutStyle::ribbons, 1, 1}));
  showFrames(governor, 1000, 0.002);
  EXPECT_EQ(governor.detail(), kFinest);
}

TEST(DetailGovernor, RemembersASlowDevice) {
  DetailGovernor governor(kSmall);
  showFrames(governor, 200, 0.1);
  governor.begin({17, 20, 3});
  EXPECT_NE(governor.detail(), kFinest);
}

TEST(DetailGovernor, DrawsAFrameThatStaysFinerThanOneThatMoves) {
  DetailGovernor governor({60, 60, 3});
  EXPECT_EQ(governor.detail().samples, 1);
  EXPECT_EQ(governor.still(), (Detail{StrutStyle::ribbons, 4, 1}));
  EXPECT_EQ(DetailGovernor(kHuge).still().style, StrutStyle::lines);
}

TEST(DetailGovernor, KeepsToTheStyleThatTheUserChose) {
  for (const StrutStyle style : {StrutStyle::lines, StrutStyle::ribbons, StrutStyle::tubes}) {
    DetailGovernor governor(kSmall);
    governor.keepTo(style);
    EXPECT_EQ(governor.detail(), (Detail{style, 4, 1}));
    showFrames(governor, 100, 1);
    EXPECT_EQ(governor.detail().style, style);
    EXPECT_EQ(governor.detail().samples, 1);
    governor.begin(kHuge);
    EXPECT_EQ(governor.detail().style, style);
    EXPECT_EQ(governor.still().style, style);
  }
}

TEST(DetailGovernor, DrawsFewerLinesThroughALargeGridButAllRibbonsThatTheUserChose) {
  DetailGovernor governor(kHuge);
  governor.keepTo(StrutStyle::lines);
  EXPECT_GT(governor.detail().stride, 1);
  governor.keepTo(StrutStyle::ribbons);
  EXPECT_EQ(governor.detail(), (Detail{StrutStyle::ribbons, 1, 1}));
}

TEST(DetailGovernor, ChoosesAgainWhenTheUserLeavesItTheStyle) {
  DetailGovernor governor(kSmall);
  governor.keepTo(StrutStyle::lines);
  governor.keepTo(std::nullopt);
  EXPECT_EQ(governor.detail(), kFinest);
}

TEST(DetailGovernor, IsNotDisturbedByTheSameChoice) {
  DetailGovernor governor(kSmall);
  showFrames(governor, 40, 0.2);
  const Detail before = governor.detail();
  ASSERT_NE(before, kFinest);
  governor.keepTo(std::nullopt);
  EXPECT_EQ(governor.detail(), before);
}

TEST(DetailGovernor, DoesNotTryALevelThatWouldBeLate) {
  DetailGovernor governor(kHuge);
  const Detail before = governor.detail();
  showFrames(governor, 1000, 0.018);
  EXPECT_EQ(governor.detail(), before);
}

}  // namespace
}  // namespace morphgrid
