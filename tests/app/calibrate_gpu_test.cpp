// The command that calibrates, as a user calls it. It needs no device.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <sstream>

#include "core/read_file.h"
#include "print/print_material.h"
#include "tests/app/subprocess.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;
using Arguments = std::vector<std::string>;

class CalibrateCommand : public testing::Test {
 protected:
  ProcessResult calibrate(Arguments arguments) const {
    arguments.insert(arguments.begin(), "calibrate");
    for (const char* more :
         {"--printer", "printers/prusa_mk4.toml", "--material", "materials/pla_0.08.toml"}) {
      arguments.push_back(more[0] == '-' ? std::string(more) : (sourceFolder() / more).string());
    }
    return runMorphgrid(arguments);
  }
  std::string path(const std::string& name) const { return folder_ / name; }

  /// The table with lengths and heights as if all came out the same share of what was printed.
  static std::string filledIn(const std::string& table, double along, double across) {
    std::istringstream lines(table);
    std::string result;
    for (std::string line; std::getline(lines, line);) {
      std::vector<std::string> cells;
      std::istringstream row(line);
      for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
      if (line[0] == '#' || cells[0] == "specimen") {
        result += line + '\n';
        continue;
      }
      cells.resize(12);
      const double struts = std::stod(cells[2]), pitch = std::stod(cells[3]),
                   share = std::stod(cells[4]), hub = std::stod(cells[6]),
                   height = std::stod(cells[7]) + std::stod(cells[8]);
      if (cells[9].empty()) {
        const double change = share * along + (1 - share) * across;
        cells[9] = std::to_string(struts * ((pitch - hub) * (1 + change) + 0.95 * hub));
      }
      if (cells[10].empty()) cells[10] = std::to_string(1.1 * height);
      for (const std::string& cell : cells) result += cell + ',';
      result += '\n';
    }
    return result;
  }

  TemporaryFolder folder_;
};

TEST_F(CalibrateCommand, SpecimensMeasuredMakeAMaterial) {
  const ProcessResult printed = calibrate({"print", "--out", path("specimens")});
  EXPECT_EQ(printed.exitCode, 0) << printed.output;
  EXPECT_THAT(printed.output, HasSubstr("15 specimens, "));
  const std::string table = readFile(path("specimens/measured.csv"));
  folder_.write("mine.csv", filledIn(table, -0.4, 0.06));
  const ProcessResult fitted = calibrate({"fit", path("mine.csv")});
  EXPECT_EQ(fitted.exitCode, 0) << fitted.output;
  EXPECT_THAT(fitted.output, HasSubstr("length, laid along"));
  EXPECT_THAT(fitted.output, HasSubstr("they add up"));
  const PrintMaterial material = readPrintMaterial(path("mine.toml"));
  EXPECT_NEAR(material.along.change, -0.4, 1e-6);
  EXPECT_NEAR(material.across.change, 0.06, 1e-6);
  EXPECT_NEAR(material.hub.change, -0.05, 1e-5);
  EXPECT_NEAR(material.tube.change, 0.1, 1e-5);
  EXPECT_THAT(material.source, HasSubstr("mine.csv"));
}

TEST_F(CalibrateCommand, NothingIsLostToAFit) {
  ASSERT_EQ(calibrate({"print", "--out", path("specimens"), "--quiet"}).exitCode, 0);
  const std::string table = filledIn(readFile(path("specimens/measured.csv")), -0.4, 0.06);
  for (const char* name : {"mine.csv", "table.toml"}) {
    folder_.write(name, table);
    const ProcessResult result = calibrate({"fit", path(name), "--out", path(name)});
    EXPECT_EQ(result.exitCode, 2) << result.output;
    EXPECT_THAT(result.output, HasSubstr("is the table of measurements, which would be lost"));
    EXPECT_EQ(readFile(path(name)), table);
  }
  EXPECT_EQ(calibrate({"fit", path("table.toml")}).exitCode, 2);
  folder_.write("mine.toml", "[surface]\n");
  EXPECT_EQ(calibrate({"fit", path("mine.csv")}).exitCode, 2);
  EXPECT_EQ(readFile(path("mine.toml")), "[surface]\n");
  for (int fit = 0; fit < 2; ++fit) {  // The second replaces the first's.
    EXPECT_EQ(calibrate({"fit", path("mine.csv"), "--out", path("fitted.toml")}).exitCode, 0);
  }
  std::filesystem::create_directory(path("folder"));
  const ProcessResult blocked = calibrate({"fit", path("mine.csv"), "--out", path("folder")});
  EXPECT_EQ(blocked.exitCode, 5);
  EXPECT_THAT(blocked.output, HasSubstr("folder: cannot be written: Is a directory"));
}

TEST_F(CalibrateCommand, RefusalsWriteNothing) {
  const ProcessResult wide = calibrate({"print", "--out", path("specimens"), "--pin", "15"});
  EXPECT_EQ(wide.exitCode, 2);
  EXPECT_THAT(wide.output, HasSubstr("a thinner pin (--pin)"));
  EXPECT_FALSE(std::filesystem::exists(path("specimens")));
  folder_.write("mine.csv", "specimen,length\n");
  const ProcessResult unfit = calibrate({"fit", path("mine.csv")});
  EXPECT_EQ(unfit.exitCode, 2);
  EXPECT_THAT(unfit.output, HasSubstr("mine.csv:1:10: length is no column"));
  EXPECT_FALSE(std::filesystem::exists(path("mine.toml")));
  const ProcessResult missing = calibrate({"fit", path("none.csv")});
  EXPECT_EQ(missing.exitCode, 2);
  EXPECT_THAT(missing.output, HasSubstr("none.csv"));
  EXPECT_EQ(runMorphgrid({"calibrate"}).exitCode, 2);
}

}  // namespace
}  // namespace morphgrid
