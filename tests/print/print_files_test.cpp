// Printer and material files: what ships can be read, what is wrong is told.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "core/read_file.h"
#include "print/gcode_template.h"
#include "print/print_material.h"
#include "print/printer.h"
#include "tests/support/folders.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::HasSubstr;

std::string replaced(std::string text, const std::string& what, const std::string& by) {
  const auto at = text.find(what);
  EXPECT_NE(at, text.npos) << what;
  return text.replace(at, what.size(), by);
}

template <typename Read>
std::string problemsOf(const Read& read, const std::string& text) {
  const TemporaryFolder folder;
  try {
    read(folder.write("file.toml", text));
  } catch (const InputError& error) {
    return folder.withoutPath(error.what());
  }
  return "";
}

std::string printerText() { return readFile(sourceFolder() / "printers/prusa_mk4.toml"); }
std::string materialText() { return readFile(sourceFolder() / "materials/pla_0.08.toml"); }

TEST(PrintFiles, AllThatShipCanBeRead) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(sourceFolder() / "printers")) {
    const Printer printer = readPrinter(entry.path());
    EXPECT_GT(printer.bedX, 200) << entry.path();
    EXPECT_THAT(printer.start, HasSubstr("M83")) << entry.path();
    ++count;
  }
  EXPECT_EQ(count, 3);
  for (const auto& entry : std::filesystem::directory_iterator(sourceFolder() / "materials")) {
    EXPECT_FALSE(readPrintMaterial(entry.path()).caveat.empty()) << entry.path();
    ++count;
  }
  EXPECT_EQ(count, 5);
}

TEST(PrintFiles, TheCalibrationIsThePublishedOne) {
  const PrintMaterial thin = readPrintMaterial(sourceFolder() / "materials/pla_0.08.toml");
  EXPECT_EQ(thin.along.change, -0.42);
  EXPECT_EQ(thin.across.change, 0.08);
  EXPECT_EQ(thin.along.heightChange, 0.52);
  EXPECT_NEAR(thin.strutHeight(), 0.8, 1e-12);
  EXPECT_FALSE(thin.hub.isMeasured);
  const PrintMaterial thick = readPrintMaterial(sourceFolder() / "materials/pla_0.10.toml");
  EXPECT_EQ(thick.along.change, -0.3087);
  EXPECT_EQ(thick.across.change, 0.0553);
}

TEST(PrintFiles, WhatIsWrongWithAPrinterIsTold) {
  EXPECT_EQ(
      problemsOf(readPrinter, replaced(printerText(), "line_width = 0.45", "line_width = 0.7")),
      "file.toml:9:14: line_width must be >= 0.4 and <= 0.68 with a nozzle of 0.4 mm, got 0.7");
  EXPECT_THAT(problemsOf(readPrinter, replaced(printerText(), "{bed}", "{bet}")),
              HasSubstr("start: {bet} stands for nothing; there are {bed}, {nozzle}"));
  EXPECT_THAT(problemsOf(readPrinter, replaced(printerText(), "[0.05, 0.30]", "[0.3, 0.05]")),
              HasSubstr("layer_heights must be the lower and the higher of two"));
  EXPECT_THAT(problemsOf(readPrinter, replaced(printerText(), "marlin", "merlin")),
              HasSubstr("flavour must be"));
  EXPECT_THAT(problemsOf(readPrinter, replaced(printerText(), "lift =", "lift_height =")),
              HasSubstr("lift_height"));
  EXPECT_THAT(problemsOf(readPrinter, "name = \"x\"\n"), HasSubstr("bed"));
}

TEST(PrintFiles, NumbersThatNoPrinterHasAreRefused) {
  const auto refused = [](const char* key, const char* value, const char* by) {
    const std::string problem =
        problemsOf(readPrinter, replaced(printerText(), fmt::format("\n{} = {}", key, value),
                                         fmt::format("\n{} = {}", key, by)));
    EXPECT_THAT(problem, testing::AllOf(HasSubstr(fmt::format("{} must be a number", key)),
                                        HasSubstr("got ")))
        << by;
  };
  refused("travel_speed", "150", "1e-9");
  refused("retract_speed", "35", "0.001");
  refused("retract", "0.7", "1e9");
  refused("filament_diameter", "1.75", "1e-9");
  refused("acceleration", "1000", "1e-300");
  refused("margin", "5", "3000");
  refused("lift", "0.2", "1e9");
  refused("jerk", "8", "1e-12");
  EXPECT_THAT(problemsOf(readPrinter, replaced(printerText(), "\nmargin = 5", "\nmargin = 105")),
              HasSubstr("margin leaves nothing of the bed of 250 x 210 mm, got 105"));
  EXPECT_THAT(problemsOf(readPrintMaterial, replaced(materialText(), "nozzle_temperature = 190",
                                                     "nozzle_temperature = 5000")),
              HasSubstr("nozzle_temperature must be a number >= 100 and <= 500, got 5000"));
  EXPECT_THAT(problemsOf(readPrintMaterial, replaced(materialText(), "speed = 30", "speed = 1e-6")),
              HasSubstr("along.speed must be a number"));
}

TEST(PrintFiles, AStartWithAbsoluteExtrusionIsRefused) {
  const auto startsWith = [](const char* by, const char* flavour = "marlin") {
    return problemsOf(readPrinter, replaced(replaced(printerText(), "M83", by), "marlin", flavour));
  };
  EXPECT_EQ(startsWith("m83 ; relative"), "");
  EXPECT_EQ(startsWith("M82\nM83"), "");
  EXPECT_EQ(startsWith("M83\nG90", "klipper"), "");
  EXPECT_THAT(startsWith("M82"), HasSubstr("start makes E absolute by its last M82"));
  EXPECT_THAT(startsWith("M83\nM82"), HasSubstr("start makes E absolute by its last M82"));
  EXPECT_THAT(startsWith("M83\nG90"), HasSubstr("start makes E absolute by its last G90"));
  EXPECT_THAT(startsWith("; M83", "rrf"), HasSubstr("start must hold M83"));
  EXPECT_THAT(startsWith("G91\nM83"), HasSubstr("start makes coordinates relative"));
}

TEST(PrintFiles, AFileOfAnotherKindIsToldInALine) {
  EXPECT_EQ(problemsOf(readPrinter, materialText()),
            "file.toml: is a material file, where a printer file is due");
  EXPECT_EQ(problemsOf(readPrintMaterial, printerText()),
            "file.toml: is a printer file, where a material file is due");
  EXPECT_EQ(problemsOf(readPrinter, "[surface]\nkind = \"bezier\"\n"),
            "file.toml: is a scene, where a printer file is due");
}

TEST(PrintFiles, WhatIsWrongWithAMaterialIsTold) {
  const auto problems = [&](const char* what, const char* by) {
    return problemsOf(readPrintMaterial, replaced(materialText(), what, by));
  };
  EXPECT_THAT(problems("lines = 3", "lines = 4"), HasSubstr("strut.lines must be odd, got 4"));
  EXPECT_THAT(problems("change = -0.42", "change = 0.08"),
              HasSubstr("along.change must be below across.change, 0.08, got 0.08"));
  EXPECT_THAT(problems("pass_height = 0.08", "pass_height = 0.08\nheight_step = -0.02"),
              HasSubstr("strut.height_step must leave every pass a height"));
  EXPECT_THAT(problems("bath = 80", "bath = 40"), HasSubstr("bath must be above"));
  EXPECT_THAT(problems("caveat", "caveats"), HasSubstr("caveat"));
}

TEST(GcodeTemplate, FillsWordsInBraces) {
  EXPECT_EQ(fillTemplate("M140 S{bed}\n{x 1} {A} {}{bed\n", {{"bed", "60"}}),
            "M140 S60\n{x 1} {A} {}{bed");
  EXPECT_EQ(unknownPlaceholders("{a}{b}{a}{bed}", {"bed"}), (std::vector<std::string>{"a", "b"}));
}

}  // namespace
}  // namespace morphgrid
