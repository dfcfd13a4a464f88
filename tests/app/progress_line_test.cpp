#include "app/progress_line.h"

#include <gtest/gtest.h>

#include <cmath>

namespace morphgrid {
namespace {

TEST(EstimateSecondsLeft, ExtendsTheFallOfTheResidual) {
  std::vector<ConvergenceSample> samples;
  for (int n = 1; n <= 10; ++n) {
    samples.push_back({n, 1.0, std::pow(10.0, -n), double(n)});  // A decade a second.
  }
  EXPECT_NEAR(estimateSecondsLeft(samples, 1e-13), 3, 1e-9);
  EXPECT_EQ(estimateSecondsLeft(samples, 1e-5), 0);
}

TEST(EstimateSecondsLeft, IsUnknownUntilSamplesOfTheGridTellARate) {
  std::vector<ConvergenceSample> samples;
  const auto add = [&](double share, int n) {
    samples.push_back({n, 1.0, std::pow(10.0, -n), double(n), share});
  };
  for (int n = 1; n <= 10; ++n) add(0.25, n);
  EXPECT_NEAR(estimateSecondsLeft(samples, 1e-13), 3, 1e-9);
  for (int n = 1; n <= 7; ++n) {
    add(1, 10 + n);
    EXPECT_LT(estimateSecondsLeft(samples, 1e-20), 0) << n;
  }
  add(1, 18);
  EXPECT_NEAR(estimateSecondsLeft(samples, 1e-20), 2, 1e-9);
}

TEST(EstimateSecondsLeft, TakesNoSampleThatWaitedForAKernelForARate) {
  std::vector<ConvergenceSample> samples;
  double seconds = 0;
  for (int n = 1; n <= 10; ++n) {
    seconds += n % 3 == 0 ? 100 : 1;
    samples.push_back({n, 1.0, std::pow(10.0, -n), seconds});
  }
  EXPECT_NEAR(estimateSecondsLeft(samples, 1e-13), 3, 1e-9);
}

TEST(ProgressLine, TellsWhatTheRunHasToCome) {
  testing::internal::CaptureStderr();
  ProgressLine line("full", 1e-9, {.secondsBefore = 3, .afterwards = 0.5});
  line.tell("12 iterations", 10, 20);
  line.tell("13 iterations", 20, -1);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "full: 12 iterations, about 35 s left\nfull: 13 iterations, time left unknown\n");
}

TEST(EstimateSecondsLeft, IsUnknownWhereNothingFalls) {
  EXPECT_LT(estimateSecondsLeft({}, 1e-9), 0);
  EXPECT_LT(estimateSecondsLeft({{1, 1.0, 0.5, 1}, {2, 1.0, 0.5, 2}}, 1e-9), 0);
}

TEST(EstimateSecondsLeft, IsUnknownFarBeyondWhatWasSeen) {
  std::vector<ConvergenceSample> samples;
  // A residual that hardly falls just now says nothing of the next hour.
  for (int n = 1; n <= 20; ++n) samples.push_back({n, 1.0, std::pow(0.99, n), double(n)});
  EXPECT_LT(estimateSecondsLeft(samples, 1e-9), 0);
  EXPECT_NEAR(estimateSecondsLeft(samples, 0.8), 2.2, 0.1);
}

}  // namespace
}  // namespace morphgrid
