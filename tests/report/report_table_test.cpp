#include "report/report_table.h"

#include <fmt/format.h>
#include <gmock/gmock.h>

#include <tuple>

#include "tests/report/sample_record.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;

TEST(ReportTable, ShowsThePaperBesideOursWhereItHasFigures) {
  RunRecord record = sampleRecord();
  EXPECT_THAT(toTable(record), testing::Not(HasSubstr("paper Fig.")));
  PublishedFigures paper;
  paper.figure = "Fig. 4";
  paper.anglePercent = 7.55;
  record.published = paper;
  EXPECT_THAT(toTable(record), HasSubstr("paper Fig. 4"));
  EXPECT_THAT(toTable(record), HasSubstr("7.55 %"));
}

TEST(ReportTable, SendsNoControlCharactersToATerminal) {
  RunRecord record = sampleRecord();
  record.title = "a\x1b[31m\nb";
  record.model = "m\x07";
  EXPECT_THAT(toTable(record), testing::StartsWith("a\\x1b[31m\\x0ab "));
  EXPECT_THAT(toTable(record), HasSubstr("m\\x07"));
}

TEST(ReportTable, HasDigitsEnoughForTrueShapes) {
  RunRecord record = sampleRecord();
  record.distance->rmsPercent = 0.00216;
  record.distance->maxPercent = 4.418;
  EXPECT_THAT(toTable(record), HasSubstr("0.0022 / 4.42 %"));
}

TEST(ReportTable, CallsTheStageAfterInverseDesignItsEnd) {
  RunRecord record = sampleRecord();
  EXPECT_THAT(toTable(record), HasSubstr("\n  full: "));
  const InverseStep step{InverseStep::Kind::design, 0, 4, 5, 6, 2.5, 7, 8, 9, 0.5};
  record.inverse = InverseDesign{{}, {}, {step}, "all steps done", {}};
  record.beforeInverse = StageEffort{21, 0.5};
  EXPECT_THAT(toTable(record),
              HasSubstr("\n  full:     21 iterations, 0.50 s\n  inverse design: "));
  EXPECT_THAT(toTable(record), testing::ContainsRegex("inverse design: .*\n  its end: "));
}

TEST(ReportTable, GivesTheCheckFromFlatARowOfItsOwn) {
  RunRecord record = sampleRecord();
  const InverseStep step{InverseStep::Kind::design, 0, 4, 5, 6, 2.5, 7, 8, 9, 0.5};
  record.inverse = InverseDesign{{}, {}, {step}, "all steps done", {}};
  EXPECT_THAT(toTable(record), testing::Not(HasSubstr("check from flat")));
  for (const auto& [isSame, isSettled, outcome] :
       {std::tuple(true, true, "the design's equilibrium"),
        std::tuple(false, true, "ANOTHER equilibrium"),
        std::tuple(true, false, "NOT at rest: unknown")}) {
    record.inverse->fromFlat = FromFlat{isSame, 2.25, {}, isSettled, 1234, 1.5};
    EXPECT_THAT(toTable(record), HasSubstr(fmt::format("  check from flat: 1234 cycles ({}), "
                                                       "distance 2.25 %, 1.50 s\n",
                                                       outcome)));
  }
}

TEST(ReportTable, SpeaksOfFeasibilityWhereSomethingIsWrong) {
  RunRecord record = sampleRecord();
  record.shrink->strutsAtLimit = 0;
  for (const char* row :
       {"at the limit", "must grow", "inverted", "collapsed", "self-intersecting", "too close"}) {
    EXPECT_THAT(toTable(record), testing::Not(HasSubstr(row)));
  }
  record.shrink->strutsGrowing = 5;
  record.feasibility->cells.inverted = 3;
  record.feasibility->selfIntersection.cells = 2;
  EXPECT_THAT(toTable(record), HasSubstr("  struts that must grow                  5\n"
                                         "  inverted cells                         3\n"
                                         "  self-intersecting cells                2\n"));
}

TEST(ReportTable, TellsHowTheNetRuns) {
  RunRecord record = sampleRecord();
  EXPECT_THAT(toTable(record), testing::Not(HasSubstr("off 90 deg")));
  record.net = NetFigures{NetKind::orthogonal, 1.25, 0.5, {3.5, 0.01, 0.5}};
  EXPECT_THAT(toTable(record), HasSubstr("  off 90 deg, mean / max  0.6 / 28.6 deg"));
}

TEST(ReportTable, OfACheckListsTheCutoffs) {
  RunRecord record = sampleRecord();
  EXPECT_THAT(toTable(record), testing::Not(HasSubstr("suggested p")));
  record.inPlane.reset();
  record.full.reset();
  EXPECT_THAT(
      toTable(record),
      HasSubstr("  curvature cutoff               curvature spacing at most    fewest nodes\n"
                "    50 % (p = 0.5)                       0             inf               1\n"
                "    95 % (p = 0.95)                 0.4785           0.418           1e+12\n"
                "  suggested p                         0.93\n"));
  record.measurement->suggestedCutoff.reset();
  EXPECT_THAT(toTable(record), HasSubstr("  suggested p                         none\n"));
}

TEST(ReportTable, NamesTheNoiseOfAMesh) {
  RunRecord record = sampleRecord();
  EXPECT_THAT(toTable(record), HasSubstr("  curvature noise                   0.0625\n"));
  record.measurement->curvatureNoise.reset();
  EXPECT_THAT(toTable(record), testing::Not(HasSubstr("curvature noise")));
}

TEST(ReportTable, SaysWhatTheSmallestEigenvalueMeans) {
  EXPECT_THAT(toTable(sampleRecord()),
              HasSubstr("minimum: smallest eigenvalue 2e-05, residual 1e-06, 9 iterations"));
}

TEST(ReportTable, SaysWhyARunDidNotConverge) {
  RunRecord record = sampleRecord();
  record.full->converged = false;
  record.full->reason = StopReason::iterationLimit;
  EXPECT_THAT(toTable(record), HasSubstr("NOT converged: iteration limit"));
}

}  // namespace
}  // namespace morphgrid
