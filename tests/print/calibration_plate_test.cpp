// The specimens' G-code read back by a reader of its own is what measured.csv says was printed.
#include "print/calibration_plate.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <set>

#include "core/error.h"
#include "core/read_file.h"
#include "print/calibration_page.h"
#include "print/measurements.h"
#include "tests/print/gcode_reader.h"
#include "tests/print/print_samples.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using Eigen::Vector2d;
using testing::HasSubstr;

class PlateTrip : public testing::Test {
 protected:
  std::vector<const GcodeMove*> movesOf(const std::string& name) const {
    std::vector<const GcodeMove*> moves;
    for (const GcodeMove& move : read_.laid) {
      if (move.name == name) moves.push_back(&move);
    }
    return moves;
  }

  double volumeOf(const std::string& name) const {
    double filament = 0;
    for (const GcodeMove* move : movesOf(name)) filament += move->filament;
    return filament * std::numbers::pi / 4 * std::pow(plate_.plan.printer.filamentDiameter, 2);
  }

  /// Middles of the rings of a hub of a specimen.
  Vector2d hubAt(int specimen, int hub) const {
    Vector2d low(1e9, 1e9), high(-1e9, -1e9);
    for (const GcodeMove* move : movesOf(fmt::format("hub {} {}", hub, specimen))) {
      low = low.cwiseMin(move->to);
      high = high.cwiseMax(move->to);
    }
    return (low + high) / 2;
  }

  CalibrationPlate plate_ = planCalibration(samplePrinter(), sampleMaterial(), {});
  ReadGcode read_ = readGcode(writeCalibration(plate_, false).text);
};

TEST_F(PlateTrip, ChainsAreAsTheTableSays) {
  const double lines = plate_.plan.material.strut.lines;
  int chains = 0;
  for (const Measurement& row : rowsOf(plate_)) {
    if (row.kind == SpecimenKind::tubes) continue;
    const int number = std::stoi(row.specimen);
    EXPECT_NEAR((hubAt(number, row.struts) - hubAt(number, 0)).norm(), row.length(), 2e-3);
    EXPECT_NEAR((hubAt(number, 1) - hubAt(number, 0)).norm(), row.pitch, 2e-3);
    // Volume laid along, over that of a strut that is laid along from ring to ring.
    const double free = row.pitch - row.hub;
    const double width = plate_.plan.printer.lineWidth;
    double full = 0;
    for (int pass = 0; pass < plate_.plan.material.strut.passes; ++pass) {
      PrintMaterial material = plate_.plan.material;
      material.strut.heightStep = row.heightStep;
      const Bead bead{width, material.heightOf(pass)};
      const double zone = row.shareAlong * free - (row.shareAlong == 0.5 ? width / 2 : 0);
      const double pieces = row.shareAlong == 0.5 ? 2 : row.shareAlong == 1 ? 1 : 0;
      full += bead.area() * (lines * zone + pieces * (lines - 1) * bead.pitch());
    }
    EXPECT_NEAR(volumeOf(fmt::format("strut u 0 {} along", number)), full, 1e-3 * full + 1e-9)
        << number;
    ++chains;
  }
  EXPECT_EQ(chains, 14);
}

TEST_F(PlateTrip, PassesOfCurlSpecimensGrow) {
  for (const Measurement& row : rowsOf(plate_)) {
    if (row.kind == SpecimenKind::tubes) continue;
    std::set<double> heights;
    for (const GcodeMove* move : movesOf(fmt::format("strut u 0 {} {}", row.specimen,
                                                     row.shareAlong > 0 ? "along" : "across"))) {
      heights.insert(move->z);
    }
    ASSERT_EQ(heights.size(), 10u) << row.specimen;
    double last = 0;
    int pass = 0;
    for (const double z : heights) {
      EXPECT_NEAR(z - last, 0.08 + row.heightStep * (pass++ - 4.5), 1.1e-3) << row.specimen;
      last = z;
    }
    EXPECT_NEAR(last, 0.8, 1e-3);
  }
}

TEST_F(PlateTrip, TubesAreAsTheTableSays) {
  int tubes = 0;
  for (const Measurement& row : rowsOf(plate_)) {
    if (row.kind != SpecimenKind::tubes) continue;
    const int hub = row.specimen.back() - 'a';
    double top = 0;
    for (const char* kind : {"hub", "tube"}) {
      for (const GcodeMove* move : movesOf(fmt::format("{} {} 15", kind, hub))) {
        top = std::max(top, move->z);
      }
    }
    EXPECT_NEAR(top, row.height + row.tube, 1e-3);
    ++tubes;
  }
  EXPECT_EQ(tubes, 6);
}

TEST_F(PlateTrip, NothingIsLaidTwiceBesideTheBedOrInAHole) {
  const PrintPlan& plan = plate_.plan;
  double last = 0;
  for (const GcodeMove& move : read_.laid) {
    EXPECT_GE(move.to.minCoeff(), plan.printer.lineWidth / 2);
    EXPECT_LE(move.to.x(), plan.printer.bedX);
    EXPECT_LE(move.to.y(), plan.printer.bedY);
    if (move.type == "Custom") continue;
    EXPECT_GE(move.z, last - 1e-9);  // What lies lower is laid first.
    last = move.z;
    for (const Specimen& specimen : plate_.specimens) {
      for (int n = 0; n <= specimen.struts; ++n) {
        const Vector2d hub = plan.positions.col(specimen.firstHub + n);
        EXPECT_GE((move.to - hub).norm(), plan.hub.hole / 2);
      }
    }
  }
  EXPECT_NEAR(read_.filament + plan.printer.retraction, read_.totals.at("filament used [mm]"),
              0.02);
}

TEST_F(PlateTrip, NumbersStayClearOfOtherSpecimens) {
  for (const Specimen& specimen : plate_.specimens) {
    const auto strokes = numberOf(plate_, specimen);
    EXPECT_GE(strokes.size(), 3u);
    const double row = plate_.plan.positions(1, specimen.firstHub);
    const double edge = plate_.plan.positions(0, specimen.firstHub) - plate_.plan.hub.diameter / 2;
    for (std::size_t n = 0; n < strokes.size(); ++n) {
      for (const Vector2d& point : strokes[n]) {
        EXPECT_LE(std::abs(point.y() - row), 4);
        EXPECT_LE(point.x(), n == 0 ? edge + 1e-9 : edge - 1);  // The line joins them to the hub.
      }
    }
  }
}

TEST(CalibrationPlate, RefusesWhatCannotBeLaid) {
  Printer small = samplePrinter();
  small.bedX = small.bedY = 120;
  const auto problemOf = [](const Printer& printer, const PrintMaterial& material,
                            const PrintRequest& request) -> std::string {
    try {
      planCalibration(printer, material, request);
    } catch (const InputError& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_THAT(problemOf(small, sampleMaterial(), {}), HasSubstr("do not fit 120 x 120 mm"));
  EXPECT_THAT(problemOf(samplePrinter(), sampleMaterial(), {.pin = 8}),
              HasSubstr("thinner pin (--pin)"));
  Printer coarse = samplePrinter();
  coarse.leastHeight = 0.08;
  EXPECT_THAT(problemOf(coarse, sampleMaterial(), {}), HasSubstr("the lowest passes are 0.0575"));
}

TEST(CalibrationFiles, AreWrittenAllOrNone) {
  const TemporaryFolder folder;
  const CalibrationPlate plate = planCalibration(samplePrinter(), sampleMaterial(), {});
  const TierFigures figures = writeCalibrationFiles(plate, folder.path(), true);
  EXPECT_EQ(folder.fileCount(), 3);
  EXPECT_GT(figures.grams, 1);
  EXPECT_LT(figures.grams, 6);
  const std::string page = readFile(folder / "calibration.html");
  EXPECT_THAT(page, HasSubstr("length_after_mm"));
  EXPECT_THAT(page, HasSubstr("1.75 mm pin through every hub"));
  EXPECT_NO_THROW(writeCalibrationFiles(plate, folder.path(), true));  // Nothing is lost.
  folder.write("measured.csv", "filled in");
  EXPECT_THROW(writeCalibrationFiles(plate, folder.path(), false), InputError);
  EXPECT_EQ(readFile(folder / "measured.csv"), "filled in");
  EXPECT_EQ(readFile(folder / "calibration.html"), page);
}

TEST(WriteGcode, SetsPressureAdvanceWhereItIsGiven) {
  Printer printer = samplePrinter();
  const auto text = [&](Flavour flavour, double advance) {
    printer.flavour = flavour;
    printer.pressureAdvance = advance;
    return writeCalibration(planCalibration(printer, sampleMaterial(), {}), true).text;
  };
  EXPECT_THAT(text(Flavour::marlin, 0.045), HasSubstr("\nM900 K0.045\n"));
  EXPECT_THAT(text(Flavour::klipper, 0.045), HasSubstr("\nSET_PRESSURE_ADVANCE ADVANCE=0.045\n"));
  EXPECT_THAT(text(Flavour::rrf, 0.045), HasSubstr("\nM572 D0 S0.045\n"));
  EXPECT_THAT(text(Flavour::marlin, 0), testing::Not(HasSubstr("M900")));
}

}  // namespace
}  // namespace morphgrid
