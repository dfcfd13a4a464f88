#include "report/judge_run.h"

#include <gmock/gmock.h>

#include "tests/report/sample_record.h"

namespace morphgrid {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// With nothing wrong.
RunRecord goodRecord() {
  RunRecord record = sampleRecord();
  record.full->smallestEigenvalue.reset();
  record.distance->rmsPercent = 0.2;
  record.shrink = ShrinkFigures{};
  record.print =
      PrintAssessment{.printer = "some printer", .material = "some material", .scale = 12};
  return record;
}

std::string lineOf(const RunRecord& record) { return judgeRun(record).line(); }

TEST(JudgeRun, NothingWrongIsPrintable) { EXPECT_EQ(lineOf(goodRecord()), "printable: yes"); }

TEST(JudgeRun, AnInterruptedRunIsNotJudgedByWhatItLeft) {
  RunRecord record = goodRecord();
  record.isInterrupted = true;
  record.full->converged = false;
  record.full->reason = StopReason::interrupted;
  EXPECT_EQ(lineOf(record),
            "printable: no, because the run was interrupted (way out: run it to its end, or go on "
            "with its --checkpoint)");
}

TEST(JudgeRun, WithoutAPrinterItSaysSo) {
  RunRecord record = goodRecord();
  record.print.reset();
  EXPECT_THAT(lineOf(record), StartsWith("printable: yes, as far as grid.max_shrinkage and"));
  record.shrink->strutsOverLimit = 3;
  record.shrink->strutsUnderLeast = 4;
  EXPECT_THAT(lineOf(record),
              StartsWith("printable: no, because 7 of 2151 struts are out of range: "
                         "3 would have to shrink more than they can, 4 less"));
}

TEST(JudgeRun, EveryObstacleIsCountedWithItsWayOut) {
  RunRecord record = goodRecord();
  record.feasibility->cells.inverted = 12;
  record.feasibility->cells.collapsed = 2;
  record.feasibility->selfIntersection.cells = 5;
  record.feasibility->closeStruts = CloseStruts{.thickness = 0.5, .count = 9};
  record.distance->rmsPercent = 20;
  record.bars = BarSizes{.width = 0.1, .height = 0.4, .post = 0.1, .joint = 0};
  record.print->obstacles = {{"the sheet does not fit 250 x 210 mm", "at most 9 mm per unit"}};
  const std::string line = lineOf(record);
  EXPECT_THAT(line, AllOf(StartsWith("printable: no, because "),
                          HasSubstr("12 cells are inverted and 2 collapsed (way out: more nodes"),
                          HasSubstr("5 cells pass through others"),
                          HasSubstr("9 struts come closer to another than it is thick"),
                          HasSubstr("the result is 20 % (RMS) from its target"),
                          HasSubstr("bars are 0.4 high but the layers only 0.3 apart"),
                          HasSubstr("does not fit 250 x 210 mm (way out: at most 9 mm per unit)")));
  EXPECT_EQ(judgeRun(record).obstacles.size(), 6u);
  EXPECT_EQ(line.find('\n'), std::string::npos);
}

TEST(JudgeRun, AnotherEquilibriumFromFlatIsOne) {
  RunRecord record = goodRecord();
  record.inverse = InverseDesign{};
  record.inverse->fromFlat = FromFlat{.sameEquilibrium = false, .rmsPercent = 8.5};
  EXPECT_THAT(lineOf(record),
              HasSubstr("from flat it morphs into another equilibrium, 8.5 % (RMS) away"));
  record.inverse->fromFlat->isSettled = false;
  EXPECT_THAT(lineOf(record), HasSubstr("whether it gets there from flat is not known"));
  // What is laid stands for the design.
  const LaidShape laid{.hasTarget = true, .laidRmsPercent = 0.3, .isConverged = true};
  EXPECT_EQ(judgeRun(record, &laid).line(), "printable: yes");
}

TEST(JudgeRun, WhatDidNotComeToRestIsNotPrintable) {
  RunRecord record = goodRecord();
  record.full->converged = false;
  record.full->reason = StopReason::iterationLimit;
  EXPECT_THAT(lineOf(record), HasSubstr("did not come to rest"));
  record = goodRecord();
  record.full->smallestEigenvalue = {
      .value = -0.1, .residual = 1e-6, .iterations = 9, .converged = true};
  EXPECT_THAT(lineOf(record), HasSubstr("the full stage ended at a saddle"));
}

TEST(JudgeRun, OfASingleLayerOnlyWhatIsUselessIsTold) {
  RunRecord record = goodRecord();
  record.full.reset();
  record.print.reset();
  EXPECT_EQ(lineOf(record), "");
  record.feasibility->cells.inverted = 1;
  EXPECT_THAT(lineOf(record), StartsWith("result: useless, because 1 cell is inverted"));
}

}  // namespace
}  // namespace morphgrid
