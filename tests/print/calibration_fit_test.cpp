// A fit finds what measurements were made from, and how well it knows it.
#include "print/calibration_fit.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>

#include "core/error.h"
#include "tests/print/print_samples.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;

constexpr double kAlong = -0.41, kAcross = 0.07, kHub = -0.04, kHigher = 0.5, kHubHigher = 0.12,
                 kTube = 0.06;

/// As a bath that changes lengths so would leave the specimens.
std::vector<Measurement> measured(double mixing = 0) {
  auto rows = rowsOf(planCalibration(samplePrinter(), sampleMaterial(), {}));
  for (Measurement& row : rows) {
    const double f = row.shareAlong;
    if (row.kind == SpecimenKind::tubes) {
      row.heightAfter = row.height * (1 + kHubHigher) + row.tube * (1 + kTube);
    } else if (row.kind == SpecimenKind::chain) {
      const double change = f * kAlong + (1 - f) * kAcross + 4 * f * (1 - f) * mixing;
      const double strut = (row.pitch - row.hub) * (1 + change) + row.hub * (1 + kHub);
      row.lengthAfter = row.struts * strut;
      if (f != 0.5) row.heightAfter = row.height * (1 + kHigher);
    }
  }
  return rows;
}

std::string problemOf(const std::vector<Measurement>& rows, const std::string& table = "") {
  try {
    fitCalibration(rows, table);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(CalibrationFit, ExactMeasurementsGiveTheirChanges) {
  const CalibrationFit fit = fitCalibration(measured());
  EXPECT_NEAR(fit.along.value, kAlong, 1e-10);
  EXPECT_NEAR(fit.across.value, kAcross, 1e-10);
  EXPECT_NEAR(fit.hub.value, kHub, 1e-10);
  EXPECT_NEAR(fit.alongHeight->value, kHigher, 1e-10);
  EXPECT_NEAR(fit.acrossHeight->value, kHigher, 1e-10);
  EXPECT_NEAR(fit.hubHeight->value, kHubHigher, 1e-10);
  EXPECT_NEAR(fit.tube->value, kTube, 1e-10);
  EXPECT_EQ(fit.chains, 12);
  EXPECT_LT(fit.along.error, 1e-10);
  EXPECT_TRUE(fit.mixes());
}

TEST(CalibrationFit, ItsErrorsAreThoseOfItsScatter) {
  constexpr int kDraws = 500;
  constexpr double kReading = 0.1;  // mm
  std::mt19937_64 generator(3);
  std::normal_distribution<double> noise(0, kReading);
  const std::vector<Measurement> exact = measured();
  Eigen::MatrixXd values(kDraws, 4), variances(kDraws, 4);
  for (int draw = 0; draw < kDraws; ++draw) {
    std::vector<Measurement> rows = exact;
    for (Measurement& row : rows) {
      if (row.lengthAfter) *row.lengthAfter += noise(generator);
      if (row.heightAfter) *row.heightAfter += noise(generator) / 10;
    }
    const CalibrationFit fit = fitCalibration(rows);
    values.row(draw) << fit.along.value, fit.across.value, fit.hub.value, fit.tube->value;
    variances.row(draw) << fit.along.error, fit.across.error, fit.hub.error, fit.tube->error;
  }
  variances = variances.array().square();
  const Eigen::RowVectorXd mean = values.colwise().mean();
  for (int n = 0; n < 4; ++n) {
    const double scatter =
        std::sqrt((values.col(n).array() - mean[n]).square().sum() / (kDraws - 1));
    EXPECT_NEAR(std::sqrt(variances.col(n).mean()), scatter, 0.1 * scatter) << n;
  }
  EXPECT_NEAR(mean[0], kAlong, 1e-3);
}

TEST(CalibrationFit, TellsWhereMixingFails) {
  EXPECT_TRUE(fitCalibration(measured()).mixes());
  std::vector<Measurement> rows = measured(0.02);
  std::mt19937_64 generator(5);
  std::normal_distribution<double> noise(0, 0.05);
  for (Measurement& row : rows) {
    if (row.lengthAfter) *row.lengthAfter += noise(generator);
  }
  const CalibrationFit fit = fitCalibration(rows);
  EXPECT_FALSE(fit.mixes());
  EXPECT_NEAR(fit.mixing->value, 0.02, 4 * fit.mixing->error);
  EXPECT_THAT(calibrationNotices(fit, "t.csv").front(), HasSubstr("more than three errors"));
}

TEST(CalibrationFit, TooLittleIsTold) {
  std::vector<Measurement> rows = measured();
  std::erase_if(rows, [](const Measurement& row) { return row.pitch != 24; });
  EXPECT_THAT(problemOf(rows),
              HasSubstr("there for 6 chains of 3 shares laid along and 1 pitches"));
  EXPECT_THAT(problemOf({}), HasSubstr("there for 0 chains"));
  rows = measured();
  for (Measurement& row : rows) {
    row.heightAfter.reset();
    row.shareAlong = 1 - row.shareAlong;
  }
  EXPECT_THAT(problemOf(rows), HasSubstr("Are lengths in the wrong rows?"));
  rows = measured();
  rows[12].isFlattest = rows[13].isFlattest = true;
  EXPECT_THAT(problemOf(rows), HasSubstr("both marked as flattest"));
}

/// With calipers' errors, and lines as in a file.
std::vector<Measurement> measuredByHand(unsigned seed) {
  std::vector<Measurement> rows = measured();
  std::mt19937_64 generator(seed);
  std::normal_distribution<double> noise(0, 0.1);
  for (std::size_t n = 0; n < rows.size(); ++n) {
    rows[n].line = static_cast<int>(n) + 5;
    if (rows[n].lengthAfter) *rows[n].lengthAfter += noise(generator);
    if (rows[n].heightAfter) *rows[n].heightAfter += noise(generator) / 10;
  }
  return rows;
}

std::vector<int> doubtfulLines(const CalibrationFit& fit) {
  std::vector<int> lines;
  for (const DoubtfulMeasurement& row : fit.doubtful) lines.push_back(row.line);
  return lines;
}

TEST(CalibrationFit, GoodMeasurementsAreNotDoubted) {
  for (unsigned seed = 0; seed < 50; ++seed) {
    EXPECT_THAT(fitCalibration(measuredByHand(seed)).doubtful, testing::IsEmpty()) << seed;
  }
}

TEST(CalibrationFit, ExchangedChainsAreNamedOrRefused) {
  for (std::size_t one = 0; one < 12; ++one) {
    for (std::size_t other = 0; other < one; ++other) {
      std::vector<Measurement> rows = measuredByHand(one);
      const double difference = *rows[one].lengthAfter - *rows[other].lengthAfter;
      if (std::abs(difference) < 3) continue;  // It does not matter much.
      std::swap(rows[one].lengthAfter, rows[other].lengthAfter);
      const auto named = [&](std::size_t n) {
        return HasSubstr("mine.csv:" + std::to_string(rows[n].line) + ": specimen " +
                         rows[n].specimen + ": length_after_mm is ");
      };
      const std::string problem = problemOf(rows, "mine.csv");
      const std::string told =
          problem.empty() ? calibrationNotices(fitCalibration(rows), "mine.csv").front() : problem;
      EXPECT_THAT(told, testing::AllOf(named(one), named(other)));
    }
  }
}

TEST(CalibrationFit, AFitThatTellsNothingIsRefused) {
  std::vector<Measurement> rows = measuredByHand(1);
  std::mt19937_64 generator(2);
  std::normal_distribution<double> noise(0, 6);
  for (Measurement& row : rows) {
    if (row.lengthAfter) *row.lengthAfter += noise(generator);
  }
  EXPECT_THAT(problemOf(rows, "mine.csv"),
              testing::AllOf(testing::StartsWith("mine.csv: struts laid along come out "),
                             HasSubstr("a standard error above 2 % is of no use")));
}

TEST(CalibrationFit, AMisreadHeightIsNamed) {
  std::vector<Measurement> rows = measuredByHand(3);
  *rows[1].heightAfter += 0.4;
  *rows[15].heightAfter += 0.4;  // A tube.
  const CalibrationFit fit = fitCalibration(rows);
  EXPECT_THAT(doubtfulLines(fit), testing::UnorderedElementsAre(6, 20));
  EXPECT_NEAR(fit.doubtful.front().expected, 1.2, 0.05);
  const PrintMaterial fitted = fittedMaterial(sampleMaterial(), fit, "t.csv", "a printer", 2026);
  EXPECT_THAT(fitted.caveat, HasSubstr("2 measurements are far from the others"));
}

TEST(CalibrationFit, ASpecimenMeasuredTwiceCountsTwice) {
  std::vector<Measurement> rows = measuredByHand(4);
  const CalibrationFit once = fitCalibration(rows);
  rows.insert(rows.end(), rows.begin(), rows.begin() + 12);
  const CalibrationFit twice = fitCalibration(rows);
  EXPECT_EQ(twice.chains, 24);
  EXPECT_NEAR(twice.along.value, once.along.value, 1e-12);
  EXPECT_LT(twice.along.error, once.along.error);
}

TEST(CalibrationFit, SpecimensOfAnotherMaterialAreTold) {
  std::vector<Measurement> rows = measured();
  EXPECT_EQ(noticeOnHeights(rows, sampleMaterial()), "");
  rows[3].height = 0.64;
  EXPECT_THAT(noticeOnHeights(rows, sampleMaterial()),
              HasSubstr("specimen 4 was printed 0.64 mm high, struts of PLA, 0.08 mm passes are "
                        "0.8 mm"));
}

TEST(CalibrationFit, MakesAMaterialThatPrints) {
  std::vector<Measurement> rows = measured();
  rows[13].isFlattest = true;
  const CalibrationFit fit = fitCalibration(rows);
  const PrintMaterial fitted =
      fittedMaterial(sampleMaterial(), fit, "a \"table\"\n.csv", "a printer", 2026);
  const TemporaryFolder folder;
  const PrintMaterial read =
      readPrintMaterial(folder.write("fitted.toml", printMaterialText(fitted)));
  EXPECT_EQ(printMaterialText(read), printMaterialText(fitted));
  EXPECT_NEAR(read.along.change, fit.along.value, 1e-6);
  EXPECT_EQ(read.source, fitted.source);
  EXPECT_EQ(read.strut.heightStep, 0.005);
  EXPECT_TRUE(read.hub.isMeasured);
  EXPECT_TRUE(read.tube.isMeasured);
  EXPECT_NEAR(read.tube.error, fit.tube->error, 1e-6);
  EXPECT_THAT(read.caveat, HasSubstr("along -41.00 +- 0.00 %"));
  EXPECT_EQ(read.bedTemperature, sampleMaterial().bedTemperature);
  EXPECT_EQ(fittedMaterial(read, fit, "again.csv", "a printer", 2027).name, read.name);
}

TEST(CalibrationFit, WhatWasNotMeasuredStays) {
  std::vector<Measurement> rows = measured();
  for (Measurement& row : rows) row.heightAfter.reset();
  const CalibrationFit fit = fitCalibration(rows);
  const PrintMaterial fitted = fittedMaterial(sampleMaterial(), fit, "t.csv", "a printer", 2026);
  EXPECT_FALSE(fitted.tube.isMeasured);
  EXPECT_EQ(fitted.tube.change, sampleMaterial().tube.change);
  EXPECT_EQ(fitted.along.heightChange, sampleMaterial().along.heightChange);
  EXPECT_THAT(fitted.caveat, HasSubstr("height not measured"));
  EXPECT_EQ(calibrationNotices(fit, "t.csv").size(), 2u);
  EXPECT_THAT(calibrationTable(sampleMaterial(), fit), HasSubstr("not measured"));
}

}  // namespace
}  // namespace morphgrid
