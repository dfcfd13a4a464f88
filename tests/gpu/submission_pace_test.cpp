#include "gpu/submission_pace.h"

#include <gtest/gtest.h>

namespace morphgrid {
namespace {

TEST(SubmissionPace, ShortensWhatTakesTooLong) {
  SubmissionPace pace;
  const long before = pace.most();
  pace.learn(before, 0.1, pace.frameEvents());
  EXPECT_LT(pace.most(), before);
  for (int n = 0; n < 100; ++n) {
    pace.learn(1, 0.1, pace.frameEvents());
  }
  EXPECT_GT(pace.most(), 1) << "no submission for each call";
}

TEST(SubmissionPace, LengthensWhatIsQuickAndFull) {
  SubmissionPace pace;
  const long before = pace.most();
  pace.learn(1, 1e-4, pace.frameEvents());
  EXPECT_EQ(pace.most(), before) << "a small submission tells nothing";
  pace.learn(before, 1e-3, pace.frameEvents());
  EXPECT_GT(pace.most(), before);
}

TEST(SubmissionPace, LearnsNothingWhereAFrameWasInTheWay) {
  SubmissionPace pace;
  const long before = pace.most();
  const long events = pace.frameEvents();
  pace.beginFrame();
  pace.learn(before, 1, events);
  pace.learn(before, 1, pace.frameEvents());
  pace.endFrame();
  pace.endFrame();  // Once is enough, twice does no harm.
  EXPECT_EQ(pace.most(), before);
  pace.learn(before, 1, pace.frameEvents());
  EXPECT_LT(pace.most(), before);
}

}  // namespace
}  // namespace morphgrid
