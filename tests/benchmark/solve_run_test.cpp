#include "benchmark/solve_run.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/benchmark/sample_runs.h"

namespace morphgrid {
namespace {

constexpr double kNoNumber = std::numeric_limits<double>::quiet_NaN();

TEST(Arrival, IsWhereTheEnergyFallsToTheBound) {
  const auto arrival = arrivalAt(runWith({8, 4, 2, 1}), 3);
  ASSERT_TRUE(arrival);
  EXPECT_EQ(arrival->iterations, 3);
  EXPECT_EQ(arrival->seconds, 3);
  EXPECT_EQ(arrivalAt(runWith({8, 4, 2, 1}), 4)->iterations, 2) << "the bound itself counts";
  EXPECT_EQ(arrivalAt(runWith({8, 4, 2, 1}), 9)->iterations, 1);
}

TEST(Arrival, CountsTheTimeBeforeTheHistoryBegins) {
  SolveRun run = runWith({8, 4, 2});
  run.untilSolve = 0.5;
  EXPECT_EQ(arrivalAt(run, 4)->seconds, 2.5);
}

TEST(Arrival, IsForGood) {
  // A coarser grid has less energy at first; later it rises above the bound once more.
  EXPECT_EQ(arrivalAt(runWith({1, 9, 2, 5, 3, 2}), 3)->iterations, 5);
  EXPECT_FALSE(arrivalAt(runWith({9, 2, 5}), 3));
}

TEST(Arrival, NeverIsNothing) {
  EXPECT_FALSE(arrivalAt(runWith({8, 4}), 3));
  EXPECT_FALSE(arrivalAt(SolveRun{}, 3));
}

TEST(Arrival, WhatIsNoNumberIsNotThere) {
  EXPECT_EQ(arrivalAt(runWith({2, kNoNumber, 1}), 3)->iterations, 3);
  EXPECT_FALSE(arrivalAt(runWith({2, kNoNumber}), 3));
}

TEST(SolveRunTest, EndsAtItsLastSample) {
  EXPECT_EQ(runWith({8, 4}).energy(), 4);
  EXPECT_EQ(runWith({8, 4}).iterations(), 2);
  EXPECT_TRUE(std::isinf(SolveRun{}.energy()));
  EXPECT_EQ(SolveRun{}.iterations(), 0);
}

}  // namespace
}  // namespace morphgrid
