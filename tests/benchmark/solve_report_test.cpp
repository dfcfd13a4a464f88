#include "benchmark/solve_report.h"

#include <gmock/gmock.h>

#include "tests/benchmark/sample_runs.h"

namespace morphgrid {
namespace {

using testing::ContainsRegex;
using testing::HasSubstr;

/// A grid of three layers that multigrid solves in so many seconds and in a cycle for each energy.
Comparison solved(const char* name, int verticesU, int verticesV, double seconds,
                  std::initializer_list<double> energies) {
  return {name, {verticesU, verticesV, 3}, {}, {{"multigrid", {runOf(seconds, energies)}}}};
}

TEST(SolveReport, GrowthIsTheRatioOfCostsPerVertex) {
  // 30,000 vertices in 3 seconds and 2 cycles; 300,000 in 60 and 4.
  const std::string text = describeGrowth(
      {solved("small", 100, 100, 3, {2, 1}), solved("large", 1000, 100, 60, {4, 3, 2, 1})});
  EXPECT_THAT(text, ContainsRegex("a V-cycle, wall time +50000 +50000 +1\\.00"));
  EXPECT_THAT(text, ContainsRegex("a V-cycle, CPU time +25000 +25000 +1\\.00"));
  EXPECT_THAT(text, ContainsRegex("the full stage, wall time +100000 +200000 +2\\.00"));
  EXPECT_THAT(text, ContainsRegex("the full stage, CPU time +50000 +100000 +2\\.00"));
}

TEST(SolveReport, GrowthBeginsAtTheSizeNearestTo25000Vertices) {
  const auto tiny = solved("tiny", 10, 10, 1, {1});
  const auto small = solved("small", 100, 100, 3, {1});
  const auto large = solved("large", 1000, 100, 60, {1});
  EXPECT_THAT(describeGrowth({tiny, large, small}), ContainsRegex("small +large"));
  EXPECT_EQ(describeGrowth({large}), "");
  EXPECT_EQ(describeGrowth({}), "");
}

TEST(SolveReport, PeersThatWereCutShortAreOutrunByAtLeastTheirTime) {
  Comparison comparison = solved("cup", 100, 100, 2, {2, 1});
  comparison.full.push_back({"reference", {runOf(60, {5, 1})}});
  comparison.full.push_back({"jacobi", {runOf(60, {5, 4})}});
  const std::string text = describe(comparison);
  EXPECT_THAT(text, HasSubstr("multigrid is 1 times as fast as reference\n"));
  EXPECT_THAT(text, HasSubstr("multigrid is 30 times as fast as jacobi, or more"));
}

TEST(SolveReport, JsonGivesNoTimeOfWhatNeverArrives) {
  Comparison comparison = solved("cup", 100, 100, 2, {2, 1});
  comparison.full.push_back({"jacobi", {runOf(60, {5, 4})}});
  const nlohmann::json json = toJson(comparison);
  EXPECT_EQ(json["vertices"], 30000);
  EXPECT_EQ(json["full"][0]["seconds_to_energy"], 2);
  EXPECT_EQ(json["full"][0]["iterations_to_energy"], 2);
  EXPECT_EQ(json["full"][1]["wall_seconds"], 60);
  EXPECT_FALSE(json["full"][1].contains("seconds_to_energy"));
}

}  // namespace
}  // namespace morphgrid
