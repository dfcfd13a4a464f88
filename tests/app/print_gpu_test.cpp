// The command that prints, as a user calls it.
#include <fmt/format.h>
#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "core/read_file.h"
#include "tests/app/scene_files.h"
#include "tests/app/subprocess.h"
#include "tests/propose/bowls.h"
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

TEST_F(PrintCommand, WhatIsDesignedForItsPrintIsPrintable) {
  folder_.write("p.toml", kGoodPatch);
  const auto keys = [](const char* name, const char* file) {
    return fmt::format("{} = '{}'\n", name, (sourceFolder() / file).string());
  };
  folder_.write("scene.toml", std::string(kBezierScene) +
                                  "layers = 3\nnodes_long = 6\n[design]\n"
                                  "enforce_shrinkage = true\ncompensate = 3\n[print]\n" +
                                  keys("printer", "printers/prusa_mk4.toml") +
                                  keys("material", "materials/pla_0.08.toml"));
  for (const char* model : {"paper", "bars", "frame"}) {
    const ProcessResult run =
        runMorphgrid({"run", path("scene.toml"), "--out", path("out"), "--set",
                      std::string("material.model=") + model, "--set", "output.pictures=false"});
    EXPECT_EQ(run.exitCode, 0) << run.output;
    EXPECT_TRUE(run.output.ends_with("printable: yes\n")) << run.output;
    const auto report = nlohmann::json::parse(readFile(path("out/report.json")));
    EXPECT_TRUE(report["verdict"]["printable"]);
    EXPECT_EQ(report["shrink"]["struts_over_limit"], 0);
    EXPECT_EQ(report["shrink"]["struts_under_least"], 0);

    const ProcessResult printed = runMorphgrid({"print", path("out")});
    EXPECT_EQ(printed.exitCode, 0) << printed.output;
    EXPECT_TRUE(printed.output.ends_with("printable: yes\n")) << printed.output;
    const auto print = nlohmann::json::parse(readFile(path("out/print/print.json")));
    EXPECT_EQ(print["sizes"]["scale_mm_per_unit"], report["print"]["scale_mm_per_unit"]) << model;
    EXPECT_EQ(print["sizes"]["enlargement"], 1.0) << model;
    EXPECT_TRUE(print["struts"]["out_of_range"].empty()) << model;
  }
}

TEST_F(PrintCommand, AMeshIsPrintedByASceneThatIsProposedForIt) {
  folder_.write("bowl.obj", toObj(bowl(12)));
  const ProcessResult printed =
      print("bowl.obj", {"--out", path("out"), "--set", "grid.nodes_long=8"});
  EXPECT_THAT(printed.exitCode, testing::AnyOf(0, 3)) << printed.output;
  EXPECT_THAT(readFile(path("out/bowl.toml")), HasSubstr("prusa_mk4.toml"));
  EXPECT_TRUE(std::filesystem::exists(path("out/tier_1.gcode")));
  const ProcessResult alone = runMorphgrid({"print", path("bowl.obj")});
  EXPECT_EQ(alone.exitCode, 2);
  EXPECT_THAT(alone.output, HasSubstr("is a mesh, which says nothing of its print"));
}

TEST_F(PrintCommand, AnotherMaterialThanTheRunsIsTold) {
  folder_.write("p.toml", kGoodPatch);
  folder_.write("scene.toml",
                fmt::format("{}layers = 3\nnodes_long = 6\n[design]\nenforce_shrinkage = true\n"
                            "[print]\nprinter = '{}'\nmaterial = '{}'\n",
                            kBezierScene, (sourceFolder() / "printers/prusa_mk4.toml").string(),
                            (sourceFolder() / "materials/pla_0.08.toml").string()));
  ASSERT_EQ(runMorphgrid({"run", path("scene.toml"), "--out", path("out"), "--quiet", "--set",
                          "output.pictures=false"})
                .exitCode,
            0);
  std::string weak = readFile(sourceFolder() / "materials/pla_0.08.toml");
  weak.replace(weak.find("change = -0.42"), 14, "change = -0.05");
  folder_.write("weak.toml", weak);
  const ProcessResult result =
      runMorphgrid({"print", path("out"), "--material", path("weak.toml"), "--enlarge", "1"});
  EXPECT_EQ(result.exitCode, 3) << result.output;
  EXPECT_THAT(result.output, HasSubstr("PLA, 0.08 mm passes has changed since the run"));
  EXPECT_THAT(result.output,
              HasSubstr("run it anew with what it is printed with, morphgrid run " +
                        path("scene.toml") + " --set print.material=" + path("weak.toml")));
  EXPECT_THAT(result.output, Not(HasSubstr("a [print] section")));
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
  refused({"--scale", "-4"}, "--scale: must be a number >= 1e-06 and <= 1e+06, got -4");
  refused({"--tolerance", "0.1", "--seed", "-1"}, "--seed: must be an integer >= 0");
  refused({"--passes", "40"}, "but a strut of 3.20 mm swells to 4.86 mm: ");
  refused({"--pin", "20"}, "struts are too short");
  refused({"--pin", "40"}, "--pin");
  const ProcessResult unread = runMorphgrid({"print", path("dome.toml"), "--printer",
                                             path("none.toml"), "--material", path("none.toml")});
  EXPECT_EQ(unread.exitCode, 2);
  EXPECT_THAT(unread.output, HasSubstr("none.toml"));
}

TEST_F(PrintCommand, PrintsWithErrorsAreTriedOnRequest) {
  const Arguments more{"--tolerance", "0.1", "--samples", "4", "--seed", "7", "--validate"};
  const auto printTo = [&](const std::string& out) {
    Arguments arguments{"--out", path(out)};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return print("dome.toml", arguments);
  };
  const ProcessResult result = printTo("out");
  EXPECT_EQ(result.exitCode, 0) << result.output;
  EXPECT_THAT(result.output, HasSubstr("shrinks off by 10 %"));
  EXPECT_THAT(result.output,
              HasSubstr("to where the design ends, % RMS / most, by the model paper"));
  EXPECT_THAT(result.output, HasSubstr("4 random prints each"));
  const auto tolerance = nlohmann::json::parse(readFile(path("out/print.json")))["tolerance"];
  EXPECT_EQ(tolerance["to"], "design");
  ASSERT_EQ(tolerance["prints"].size(), 4u);  // The material names no errors.
  for (const auto& kind : tolerance["prints"]) {
    EXPECT_EQ(kind["rms_percent"].size(), 4u);
    EXPECT_GT(kind["mean_rms_percent"], 0);
    EXPECT_GE(kind["rms_95_percent"], kind["mean_rms_percent"]);
    EXPECT_EQ(kind["not_converged"], 0);
  }
  EXPECT_GT(tolerance["all_less"]["rms_percent"], tolerance["undisturbed"]["rms_percent"]);
  EXPECT_EQ(tolerance["tiers"].size(), 3u);
  EXPECT_EQ(tolerance["struts"].size(), 3u);
  EXPECT_THAT(readFile(path("out/assembly.html")), HasSubstr("When shrinks are off by 10 %"));

  EXPECT_EQ(printTo("again").exitCode, 0);
  EXPECT_EQ(nlohmann::json::parse(readFile(path("again/print.json")))["tolerance"], tolerance);
  EXPECT_EQ(print("dome.toml", {"--samples", "4"}).exitCode, 2);
  EXPECT_EQ(print("dome.toml", {"--tolerance", "2"}).exitCode, 2);
}

TEST_F(PrintCommand, CtrlCStopsPrintsWithErrors) {
  Arguments arguments{"print",       path("dome.toml"),
                      "--printer",   sourceFolder() / "printers/prusa_mk4.toml",
                      "--material",  sourceFolder() / "materials/pla_0.08.toml",
                      "--out",       path("out"),
                      "--tolerance", "0.1",
                      "--samples",   "100000"};
  const ProcessResult result = runMorphgridUntil(
      [](const std::string& output) { return output.find("print ") != output.npos; }, arguments,
      SIGINT);
  EXPECT_EQ(result.exitCode, 130) << result.output;
  EXPECT_FALSE(std::filesystem::exists(path("out/print.json")));
}

TEST_F(PrintCommand, AFolderThatCannotBeWrittenStaysAsItWas) {
  std::filesystem::create_directories(path("out/tier_2.gcode"));
  std::filesystem::create_directories(path("out/assembly.html"));
  const ProcessResult result = print("dome.toml", {"--out", path("out")});
  EXPECT_EQ(result.exitCode, 5) << result.output;
  EXPECT_THAT(result.output, HasSubstr("tier_2.gcode: cannot be written: Is a directory"));
  EXPECT_THAT(result.output, HasSubstr("assembly.html: cannot be written"));
  EXPECT_FALSE(std::filesystem::exists(path("out/tier_1.gcode")));
  EXPECT_FALSE(std::filesystem::exists(path("out/print.json")));
}

}  // namespace
}  // namespace morphgrid
