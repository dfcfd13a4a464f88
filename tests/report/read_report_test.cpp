#include "report/read_report.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.h"
#include "report/report_json.h"
#include "report/report_table.h"
#include "tests/report/sample_record.h"

namespace morphgrid {
namespace {

using nlohmann::json;

/// A record in which nothing is missing.
RunRecord fullRecord() {
  RunRecord record = sampleRecord();
  record.printScale = 1.0625;
  record.mesh = MeshFigures{.file = "face.obj", .triangles = 3, .rays = 4, .missed = 1};
  record.full->reason = StopReason::iterationLimit;
  record.full->converged = false;
  record.inverse = InverseDesign{{},
                                 {},
                                 {{InverseStep::Kind::design, 0, 4, 5, 6, 2.5, 7, 8, 9, 0.5},
                                  {InverseStep::Kind::compensate, 1, 3, 4, 5, 1.5, 6, 7, 8, 1.5},
                                  {InverseStep::Kind::optimise, 1, 2, 3, 4, 0.5, 5, 6, 7, 2.5}},
                                 "all steps done",
                                 FromFlat{true, 2.25, 0.75, false, 1234, 1.5}};
  record.beforeInverse = StageEffort{21, 0.5};
  record.distance->diagonal = 17.5;
  record.distance->axisParallelDiagonal = 18.25;
  record.feasibility->cells = {3, 4, -0.5, {5, 6, 2}};
  record.feasibility->selfIntersection = {7, {8, 9, 1}};
  record.feasibility->closeStruts = CloseStruts{0.25, 2, 0.125, {1, 2, 0}};
  record.sheet = SheetFigures{0.125, 0.5, 1.5, 1000, 20, 3, 0.25, 0.75, 12, 34, 0.375, 7, 0.5};
  record.strain = StrainFigures{2.5, 0.5, 1};
  record.model = "frame";
  record.printedSheet = Eigen::Array2d(12.5, 25);
  record.bars = BarSizes{0.5, 0.25, 0.75, 0.125};
  record.print = PrintAssessment{"a printer",
                                 "a material",
                                 "p digest",
                                 "m digest",
                                 1.5,
                                 1.0625,
                                 {{"a strut is too long", "fewer nodes"}}};
  record.isInterrupted = true;
  record.deviceFailure = "lost";
  record.notices = {"one", "two"};
  return record;
}

TEST(ReadReport, GivesTheSameReportAndTable) {
  for (const RunRecord& record : {sampleRecord(), fullRecord()}) {
    const RunRecord read = readReport(toJson(record));
    EXPECT_EQ(toJson(read), toJson(record));
    EXPECT_EQ(toTable(read), toTable(record));
  }
}

TEST(ReadReport, InterruptedRunsLackWhatTakesLong) {
  RunRecord record = sampleRecord();
  record.distance->closest.reset();
  record.feasibility.reset();
  const RunRecord read = readReport(toJson(record));
  EXPECT_EQ(read.distance->maxPercent, 5);
  EXPECT_FALSE(read.distance->closest);
  EXPECT_FALSE(read.feasibility);
  EXPECT_EQ(toTable(read).find("to closest point"), std::string::npos);
}

TEST(ReadReport, WhatIsNotFiniteComesBack) {
  RunRecord record = sampleRecord();
  record.net = NetFigures{NetKind::orthogonal, 1.25, 0.5, {INFINITY, 0.125, 0.25}};
  record.full->energy = NAN;
  const RunRecord read = readReport(toJson(record));
  EXPECT_EQ(read.measurement->layerSpacingLimit, INFINITY);
  EXPECT_EQ(read.measurement->cutoffs[0].layerSpacingLimit, INFINITY);
  EXPECT_EQ(read.net->quality.strutRatio, INFINITY);
  EXPECT_NEAR(read.net->quality.meanAngleDeviation, 0.125, 1e-15);
  EXPECT_TRUE(std::isnan(read.full->energy));
}

TEST(ReadReport, AnyValueOfAnotherTypeIsRefused) {
  const json report = json::parse(toJson(fullRecord()));
  const json flat = report.flatten();
  const json other = {{"an", "object"}};
  for (const auto& [pointer, value] : flat.items()) {
    json changed = report;
    changed[json::json_pointer(pointer)] = other;
    const bool isDerived = pointer == "/grid/vertices" || pointer == "/grid/struts" ||
                           pointer.find("size_mm") != std::string::npos ||
                           pointer.find("verdict") != std::string::npos;
    if (!isDerived) {
      EXPECT_THROW(readReport(changed.dump()), InputError) << pointer;
    }
  }
}

TEST(ReadReport, RefusesWhatIsNoReport) {
  for (const char* text : {"", "{}", "[]", "null", "{\"scene\": 1}", "\xff"}) {
    EXPECT_THROW(readReport(text), InputError) << text;
  }
  json report = json::parse(toJson(fullRecord()));
  report["grid"]["nodes_u"] = -3;
  EXPECT_THROW(readReport(report.dump()), InputError);
  report["grid"]["nodes_u"] = 1LL << 40;
  EXPECT_THROW(readReport(report.dump()), InputError);
  report["grid"]["nodes_u"] = 1.5;
  EXPECT_THROW(readReport(report.dump()), InputError);
}

}  // namespace
}  // namespace morphgrid
