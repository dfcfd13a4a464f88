#include "core/parallel_for.h"

#include <gtest/gtest.h>

#include <atomic>
#include <numeric>
#include <stdexcept>
#include <thread>
#include <vector>

#include "core/cancellation.h"

namespace morphgrid {
namespace {

constexpr std::ptrdiff_t kGrain = 7;

class ParallelFor : public testing::TestWithParam<std::ptrdiff_t> {};
INSTANTIATE_TEST_SUITE_P(Counts, ParallelFor, testing::Values(0, 1, 6, 7, 8, 14, 1000));

TEST_P(ParallelFor, CallsEveryNumberOnce) {
  std::vector<int> calls(GetParam());
  parallelFor(GetParam(), kGrain, [&](std::ptrdiff_t n) { ++calls.at(n); });
  EXPECT_EQ(calls, std::vector<int>(GetParam(), 1));
}

TEST_P(ParallelFor, RangesAreConsecutiveAndOfTheGrain) {
  std::vector<std::ptrdiff_t> ends((GetParam() + kGrain - 1) / kGrain);
  parallelRanges(GetParam(), kGrain, [&](std::ptrdiff_t first, std::ptrdiff_t last) {
    EXPECT_EQ(first % kGrain, 0);
    ends.at(first / kGrain) = last;
  });
  for (std::size_t n = 0; n < ends.size(); ++n) {
    EXPECT_EQ(ends[n], std::min<std::ptrdiff_t>(GetParam(), (n + 1) * kGrain));
  }
}

/// Whoever gets there first: errors are the same in each run.
TEST(ParallelForFailures, TheFirstOneIsThrown) {
  for (int run = 0; run < 50; ++run) {
    try {
      parallelFor(1000, kGrain, [](std::ptrdiff_t n) {
        if (n >= 300 && n % 100 == 0) throw std::runtime_error(std::to_string(n));
      });
      FAIL() << "nothing was thrown";
    } catch (const std::runtime_error& error) {
      EXPECT_STREQ(error.what(), "300");
    }
  }
}

TEST(ParallelForFailures, WhatComesBeforeTheFirstOneIsDone) {
  std::atomic<int> done = 0;
  EXPECT_THROW(parallelFor(1000, kGrain,
                           [&](std::ptrdiff_t n) {
                             if (n >= 700) throw std::runtime_error("no further");
                             ++done;
                           }),
               std::runtime_error);
  EXPECT_EQ(done, 700);
}

TEST(ParallelForFailures, AfterACancellationNothingIsBegun) {
  for (int run = 0; run < 50; ++run) {
    std::atomic<int> asked = 0;
    EXPECT_THROW(parallelFor(1000, 1,
                             [&](std::ptrdiff_t) {
                               if (++asked >= 100) throw Cancelled();
                             }),
                 Cancelled);
    // Each thread may have begun one.
    EXPECT_LT(asked, 100 + static_cast<int>(std::max(1U, std::thread::hardware_concurrency())));
  }
}

}  // namespace
}  // namespace morphgrid
