// measured.csv: what is written is read, as spreadsheets leave it too; what is wrong is told.
#include "print/measurements.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/error.h"
#include "print/calibration_fit.h"
#include "tests/print/print_samples.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;

std::vector<Measurement> sampleRows() {
  return rowsOf(planCalibration(samplePrinter(), sampleMaterial(), {}));
}

std::string problemsIn(const std::string& text) {
  const TemporaryFolder folder;
  try {
    readMeasurements(folder.write("measured.csv", text));
  } catch (const InputError& error) {
    return folder.withoutPath(error.what());
  }
  return "";
}

void replaceFirst(std::string& text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  ASSERT_NE(at, text.npos) << what;
  text.replace(at, what.size(), by);
}

TEST(Measurements, AreReadAsTheyWereWritten) {
  std::vector<Measurement> rows = sampleRows();
  ASSERT_EQ(rows.size(), 20u);
  for (Measurement& row : rows) {
    if (row.kind == SpecimenKind::tubes) {
      row.heightAfter = 1.07 * (row.height + row.tube);
      continue;
    }
    const double free = row.pitch - row.hub;
    row.lengthAfter =
        row.struts * (free * (1 - 0.4 * row.shareAlong + 0.06 * (1 - row.shareAlong)) + row.hub);
  }
  rows[2].isFlattest = true;
  const TemporaryFolder folder;
  const std::string text = measurementsText(rows);
  const auto read = readMeasurements(folder.write("measured.csv", text));
  EXPECT_EQ(measurementsText(read), text);
  const CalibrationFit fit = fitCalibration(read);
  EXPECT_NEAR(fit.along.value, -0.4, 1e-10);
  EXPECT_NEAR(fit.across.value, 0.06, 1e-10);
  EXPECT_NEAR(fit.hub.value, 0, 1e-10);
  EXPECT_NEAR(fit.tube->value, 0.07, 1e-10);

  // As a spreadsheet of a country with decimal commas writes it.
  std::string german = text;
  std::replace(german.begin(), german.end(), ',', ';');
  std::replace(german.begin() + static_cast<long>(german.find("specimen;")), german.end(), '.',
               ',');
  for (auto at = german.find('\n'); at != german.npos; at = german.find('\n', at + 2)) {
    german.insert(at, "\r");
  }
  const auto other = readMeasurements(folder.write("german.csv", "\xef\xbb\xbf" + german));
  EXPECT_EQ(measurementsText(other), text);
}

TEST(Measurements, QuotesAndOrderOfColumnsDoNotMatter) {
  const TemporaryFolder folder;
  const auto rows = readMeasurements(folder.write(
      "measured.csv",
      "\"# a comment, with a comma\",,\n"
      "kind,specimen,struts,pitch_mm,share_along,height_step_mm,hub_mm,tube_mm,height_mm,"
      "height_after_mm,length_after_mm\n"
      ",,,,,,,,,,\n"
      "\"chain\", 1 ,8,\"12\",1,0,3.66,0,0.8,-,58.5\n"));
  ASSERT_EQ(rows.size(), 1u);
  EXPECT_EQ(rows[0].line, 4);
  EXPECT_EQ(rows[0].specimen, "1");
  EXPECT_EQ(rows[0].lengthAfter, 58.5);
  EXPECT_FALSE(rows[0].heightAfter);
}

TEST(Measurements, WhatIsWrongIsTold) {
  const std::string text = measurementsText(sampleRows());
  const auto problemsWith = [&](const std::string& what, const std::string& by) {
    std::string changed = text;
    replaceFirst(changed, what, by);
    return problemsIn(changed);
  };
  EXPECT_THAT(problemsWith("share_along", "share"),
              HasSubstr("measured.csv:4:31: share is no column; there are specimen, kind, "));
  EXPECT_THAT(problemsWith("share_along", "share_alon"), HasSubstr("(is it share_along?)"));
  EXPECT_THAT(problemsWith("share_along", "share"), HasSubstr("column share_along is missing"));
  EXPECT_THAT(problemsWith("tube_mm", "hub_mm"), HasSubstr("column hub_mm is there twice"));
  EXPECT_THAT(problemsWith("\n1,chain,8,12,1,", "\n1,chain,8,12,2,"),
              HasSubstr("measured.csv:5:14: share_along must be a number >= 0 and <= 1, got 2"));
  EXPECT_THAT(problemsWith("\n1,chain", "\n1,chains"),
              HasSubstr("kind must be chain or curl or tube, got chains"));
  EXPECT_THAT(problemsWith("\n1,chain,8", "\n1,chain,x"), HasSubstr("struts must be an integer"));
  EXPECT_THAT(problemsWith("\n1,chain,8", "\n1,chain,"), HasSubstr("struts is empty"));
  EXPECT_THAT(problemsWith("0.8,,,\n", "0.8,580,,\n"),
              HasSubstr("measured.csv:5:31: length_after_mm must be a number >= 19.2 and <= 384, "
                        "since 96 mm were printed, got 580"));
  EXPECT_THAT(
      problemsWith("0.8,,,\n", "0.8,58.5mm,,\n"),
      testing::AllOf(HasSubstr("length_after_mm must be a number of mm"), HasSubstr("got 58.5mm")));
  EXPECT_EQ(problemsWith("0.8,,,\n", "0.8,58.5,1.2,x\n"), "");
  EXPECT_THAT(problemsWith("0.8,,,\n", "0.8,58,5,1,2,x\n"), HasSubstr("is in no column"));
  EXPECT_THAT(problemsIn(""), HasSubstr("the line that names the columns is missing"));
  EXPECT_THAT(problemsIn("# only\n"), HasSubstr("the line that names the columns is missing"));
}

}  // namespace
}  // namespace morphgrid
