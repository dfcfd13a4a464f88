#include "gpu/submission_pace.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <thread>

namespace morphgrid {
namespace {

constexpr const char* kCheap = "cheap.comp";
constexpr const char* kDear = "dear.comp";

double groupSeconds(const SubmissionPace& pace, const char* kernel) {
  constexpr long kMany = 1000000;
  return pace.expect({{kernel, kMany}}) / kMany;
}

TEST(SubmissionPace, KnowsWhatHasRun) {
  SubmissionPace pace;
  EXPECT_FALSE(pace.knows(kCheap));
  EXPECT_GT(pace.expect({{kCheap, 1}}), SubmissionPace::kLongest) << "it is compiled first";
  pace.learn({{kCheap, 1}}, 1e3, pace.frameEvents());
  EXPECT_TRUE(pace.knows(kCheap));
  EXPECT_FALSE(pace.knows(kDear));
  EXPECT_LT(pace.expect({{kCheap, 1}}), SubmissionPace::kLongest) << "that took the compiler";
}

TEST(SubmissionPace, LearnsWhatEachKernelTakes) {
  SubmissionPace pace;
  const std::vector<CallWork> cheap{{kCheap, 10000}};
  const std::vector<CallWork> dear{{kDear, 100}, {kDear, 300}};
  const std::vector<CallWork> both{{kCheap, 10000}, {kDear, 100}};
  for (int n = 0; n < 50; ++n) {
    pace.learn(cheap, 10000 * 1e-7, pace.frameEvents());
    pace.learn(dear, 400 * 5e-5, pace.frameEvents());
    pace.learn(both, 10000 * 1e-7 + 100 * 5e-5, pace.frameEvents());
  }
  EXPECT_NEAR(groupSeconds(pace, kCheap), 1e-7, 1e-8);
  EXPECT_NEAR(groupSeconds(pace, kDear), 5e-5, 5e-6);
}

/// It has run.
void meet(SubmissionPace& pace, const char* kernel) {
  pace.learn({{kernel, 1}}, 1, pace.frameEvents());
}

TEST(SubmissionPace, ExpectsTheSumAndMoreOfManyCalls) {
  SubmissionPace pace;
  meet(pace, kCheap);
  meet(pace, kDear);
  const double one = pace.expect({{kCheap, 10}});
  EXPECT_DOUBLE_EQ(pace.expect({{kCheap, 10}, {kDear, 10}}), 2 * one);
  EXPECT_GT(pace.expect({{kCheap, 5}, {kCheap, 5}}), one);
}

TEST(SubmissionPace, OneSurpriseIsNotBelievedWhole) {
  SubmissionPace pace;
  meet(pace, kCheap);
  const double before = groupSeconds(pace, kCheap);
  pace.learn({{kCheap, 100}}, 1e6, pace.frameEvents());
  EXPECT_GT(groupSeconds(pace, kCheap), 2 * before);
  EXPECT_LT(groupSeconds(pace, kCheap), 10 * before);
}

TEST(SubmissionPace, LearnsNothingWhereAFrameWasInTheWay) {
  SubmissionPace pace;
  const std::vector<CallWork> work{{kCheap, 100}};
  meet(pace, kCheap);
  const double before = pace.expect(work);
  const long events = pace.frameEvents();
  pace.beginFrame();
  pace.learn(work, 1, events);
  pace.learn(work, 1, pace.frameEvents());
  pace.endFrame();
  pace.endFrame();  // Once is enough, twice does no harm.
  EXPECT_EQ(pace.expect(work), before);
  pace.learn(work, 1, pace.frameEvents());
  EXPECT_GT(pace.expect(work), before);
}

TEST(SubmissionPace, GivesWayToAFrame) {
  SubmissionPace pace;
  pace.giveWay();  // There is none.
  pace.beginFrame();
  std::atomic<bool> isDrawn = false;
  std::thread drawing([&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    isDrawn = true;
    pace.endFrame();
  });
  pace.giveWay();
  EXPECT_TRUE(isDrawn);
  drawing.join();
  pace.beginFrame();
  pace.giveWay();  // The frame never ends; this returns all the same.
}

}  // namespace
}  // namespace morphgrid
