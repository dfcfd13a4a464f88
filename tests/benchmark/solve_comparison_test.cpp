#include "benchmark/solve_comparison.h"

#include <gtest/gtest.h>

#include "tests/benchmark/sample_runs.h"

namespace morphgrid {
namespace {

TEST(MethodRunsTest, MediansCountAndTheLeastEnergy) {
  const MethodRuns runs{"multigrid", {runOf(9, {5, 2}), runOf(1, {5, 3}), runOf(4, {5, 4})}};
  EXPECT_EQ(runs.wallSeconds(), 4);
  EXPECT_EQ(runs.cpuSeconds(), 2);
  EXPECT_EQ(runs.energy(), 2);
}

TEST(MethodRunsTest, AllMustConverge) {
  MethodRuns runs{"multigrid", {runOf(1, {1}), runOf(1, {1})}};
  EXPECT_TRUE(runs.converged());
  runs.runs.back().ending = "time limit";
  EXPECT_FALSE(runs.converged());
}

TEST(MethodRunsTest, ArrivesWithinAMillionthOfTheLeastEnergy) {
  const MethodRuns runs{"multigrid", {runOf(4, {2, 1.000002, 1.0000009, 1})}};
  ASSERT_TRUE(runs.arrival(1));
  EXPECT_EQ(runs.arrival(1)->iterations, 3);
  EXPECT_FALSE(runs.arrival(0.99));
}

TEST(MethodRunsTest, ArrivesWhenAllRunsDo) {
  MethodRuns runs{"multigrid", {runOf(4, {2, 1}), runOf(4, {2, 1}), runOf(4, {2, 1})}};
  runs.runs[0].untilSolve = 0.25;
  runs.runs[1].untilSolve = 0.75;
  runs.runs[2].untilSolve = 0.5;
  EXPECT_EQ(runs.arrival(1)->seconds, 2.5);
  runs.runs[2] = runOf(4, {2, 1.5});
  EXPECT_FALSE(runs.arrival(1));
}

TEST(ComparisonTest, TheLeastEnergyIsThatOfAllMethods) {
  const Comparison comparison{
      "cup", {2, 2, 3}, {}, {{"multigrid", {runOf(1, {4, 3})}}, {"jacobi", {runOf(1, {5, 2})}}}};
  EXPECT_EQ(comparison.leastEnergy(), 2);
  ASSERT_TRUE(comparison.find("jacobi"));
  EXPECT_EQ(comparison.find("jacobi")->energy(), 2);
  EXPECT_FALSE(comparison.find("reference"));
}

}  // namespace
}  // namespace morphgrid
