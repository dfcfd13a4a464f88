// The command that prints, as a user calls it.
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/read_file.h"
#include "tests/app/subprocess.h"
#include "tests/support/dome_scene.h"
#include "tests/support/folders.h"
#include "tests/support/golden_text.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;
using testing::Not;
using Arguments = std::vector<std::string>;

class PrintCommand : public testing::Test {
 protected:
  PrintCommand() { folder_.write("dome.toml", kDomeScene); }

  std::string path(const std::string& name) const { return folder_ / name; }

  ProcessResult print(const std::string& what, const Arguments& more = {}) const {
    Arguments arguments{"print",      path(what),
                        "--printer",  sourceFolder() / "printers/prusa_mk4.toml",
                        "--material", sourceFolder() / "materials/pla_0.08.toml"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return runMorphgrid(arguments);
  }

  TemporaryFolder folder_;
};

TEST_F(PrintCommand, LeavesGcodeForEveryTier) {
  ASSERT_EQ(runMorphgrid({"run", path("dome.toml"), "--out", path("dome"), "--quiet", "--set",
                          "output.pictures=false"})
                .exitCode,
            0);
  folder_.write("dome/print/tier_4.gcode", "of an earlier print");
  const ProcessResult stored = print("dome", {"--validate"});
  EXPECT_EQ(stored.exitCode, 0) << stored.output;
  EXPECT_THAT(stored.output, HasSubstr("printable: yes\n"));
  EXPECT_THAT(stored.output, HasSubstr("One laboratory, one filament, one printer"));
  EXPECT_FALSE(std::filesystem::exists(path("dome/print/tier_4.gcode")));
  const auto report = nlohmann::json::parse(readFile(path("dome/print/print.json")));
  EXPECT_EQ(report["tiers"].size(), 3u);
  EXPECT_TRUE(report["printable"]);
  EXPECT_EQ(report["distance"]["to"], "design");
  EXPECT_EQ(report["distance"]["model"], "paper");
  EXPECT_LT(report["distance"]["laid_rms_percent"], 1);
  EXPECT_TRUE(report["distance"]["same_equilibrium_from_flat"]);

  const ProcessResult anew = print("dome.toml", {"--out", path("anew"), "--quiet"});
  EXPECT_EQ(anew.exitCode, 0) << anew.output;
  for (const char* file : {"tier_1.gcode", "tier_2.gcode", "tier_3.gcode"}) {
    EXPECT_EQ(readFile(path("anew/" + std::string(file))),
              readFile(path("dome/print/" + std::string(file))));
  }
}

/// Where two documents differ: devices differ in the last digits of what they solve.
std::string differenceOf(const nlohmann::json& a, const nlohmann::json& b) {
  if (a.is_number() && b.is_number()) {
    const double x = a, y = b;
    return std::abs(x - y) <= 1e-3 * std::abs(x) + 1e-6 ? "" : a.dump() + " != " + b.dump();
  }
  if (a.type() != b.type() || a.size() != b.size()) return a.dump() + " != " + b.dump();
  if (!a.is_structured()) return a == b ? "" : a.dump() + " != " + b.dump();
  const auto left = a.items(), right = b.items();
  for (auto one = left.begin(), other = right.begin(); one != left.end(); ++one, ++other) {
    if (one.key() != other.key()) return one.key() + " != " + other.key();
    const std::string difference = differenceOf(one.value(), other.value());
    if (!difference.empty()) return one.key() + ": " + difference;
  }
  return "";
}

/// Struts of the same excess have no order.
nlohmann::json sortedReport(const std::string& text) {
  auto report = nlohmann::json::parse(text.empty() ? "{}" : text);
  if (report.contains("struts")) {
    auto& struts = report["struts"]["out_of_range"];
    std::sort(struts.begin(), struts.end(),
              [](const auto& a, const auto& b) { return a["strut"] < b["strut"]; });
  }
  return report;
}

TEST_F(PrintCommand, TheReportOfTheStripIsTheGoldenOne) {
  const ProcessResult result =
      print(sourceFolder() / "scenes/strip.toml", {"--out", path("strip"), "--quiet"});
  EXPECT_EQ(result.exitCode, 3) << result.output;
  const std::string text = readFile(path("strip/print.json"));
  const std::string difference =
      differenceOf(sortedReport(text), sortedReport(readGolden("print_strip.json")));
  if (!difference.empty())
    ADD_FAILURE() << difference << '\n' << keepActual(text, "print_strip.json");
}

TEST_F(PrintCommand, WritesSolidsForSlicersOnWish) {
  folder_.write("out/tier_4.stl", "of an earlier print");
  const ProcessResult with = print("dome.toml", {"--out", path("out"), "--stl", "--3mf"});
  EXPECT_EQ(with.exitCode, 0) << with.output;
  EXPECT_THAT(with.output, HasSubstr("STL and 3MF are for looking, for posts and for uniform "
                                     "sheets: slicers lay every strut along itself"));
  for (const char* file : {"tier_1.stl", "tier_2.stl", "tier_3.stl", "tiers.3mf"}) {
    EXPECT_GT(std::filesystem::file_size(path("out/" + std::string(file))), 1000u) << file;
  }
  EXPECT_FALSE(std::filesystem::exists(path("out/tier_4.stl")));
  const ProcessResult without = print("dome.toml", {"--out", path("out")});
  EXPECT_EQ(without.exitCode, 0) << without.output;
  EXPECT_THAT(without.output, Not(HasSubstr("for looking")));
  EXPECT_FALSE(std::filesystem::exists(path("out/tier_1.stl")));
  EXPECT_FALSE(std::filesystem::exists(path("out/tiers.3mf")));
}

TEST_F(PrintCommand, StrutsOutOfRangeAreWrittenAndTold) {
  const ProcessResult result =
      print("dome.toml", {"--out", path("out"), "--set", "surface.theta_u=[1.2, -1.2]"});
  EXPECT_EQ(result.exitCode, 3) << result.output;
  EXPECT_THAT(result.output, HasSubstr("printable: no, because "));
  EXPECT_THAT(result.output, HasSubstr("grid.max_shrinkage = "));
  EXPECT_TRUE(std::filesystem::exists(path("out/tier_3.gcode")));
}

TEST_F(PrintCommand, RefusalsWriteNothing) {
  const auto refused = [&](const Arguments& more, const std::string& message) {
    Arguments arguments{"--out", path("out")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const ProcessResult result = print("dome.toml", arguments);
    EXPECT_EQ(result.exitCode, 2) << result.output;
    EXPECT_THAT(result.output, HasSubstr(message));
    EXPECT_FALSE(std::filesystem::exists(path("out")));
  };
  refused({"--scale", "60"}, "the sheet does not fit 250 x 210 mm: at most ");
  refused({"--scale", "4"}, "struts are too short for hubs of 3.66 mm at 4 mm per unit");
  refused({"--scale", "-4"}, "--scale");
  refused({"--passes", "40"}, "but a strut of 3.20 mm swells to 4.86 mm: ");
  refused({"--pin", "20"}, "struts are too short");
  refused({"--pin", "40"}, "--pin");
  const ProcessResult unread = runMorphgrid({"print", path("dome.toml"), "--printer",
                                             path("none.toml"), "--material", path("none.toml")});
  EXPECT_EQ(unread.exitCode, 2);
  EXPECT_THAT(unread.output, HasSubstr("none.toml"));
}

TEST_F(PrintCommand, AFolderThatCannotBeWrittenStaysAsItWas) {
  std::filesystem::create_directories(path("out/tier_2.gcode"));
  const ProcessResult result = print("dome.toml", {"--out", path("out")});
  EXPECT_EQ(result.exitCode, 2) << result.output;
  EXPECT_THAT(result.output, HasSubstr("tier_2.gcode: cannot be written"));
  EXPECT_FALSE(std::filesystem::exists(path("out/tier_1.gcode")));
  EXPECT_FALSE(std::filesystem::exists(path("out/print.json")));
}

}  // namespace
}  // namespace morphgrid
