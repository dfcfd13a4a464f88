#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include <chrono>

#include "app/command_end.h"
#include "app/command_options.h"
#include "app/commands.h"
#include "core/atomic_file.h"
#include "core/create_folder.h"
#include "core/visible_text.h"
#include "print/calibration_fit.h"
#include "print/calibration_output.h"
#include "print/calibration_page.h"

namespace morphgrid {
namespace {

struct CalibrateArguments {
  std::filesystem::path printer, material, table, output;
  PrintRequest request;
  bool isPlain = false;
  bool isQuiet = false;
};

int printSpecimens(const CalibrateArguments& arguments) {
  const CalibrationPlate plate = planCalibration(
      readPrinter(arguments.printer), readPrintMaterial(arguments.material), arguments.request);
  createFolder(arguments.output, "--out " + arguments.output.string());
  const TierFigures figures = writeCalibrationFiles(plate, arguments.output, arguments.isPlain);
  if (!arguments.isQuiet) {
    fmt::print(
        "{} specimens, {:.1f} g, {:.1f} h: calibration.gcode, calibration.html, which says "
        "what to do, and measured.csv, to be filled in, in {}\n",
        plate.specimens.size(), figures.grams, figures.seconds / 3600, arguments.output.string());
  }
  return kConverged;
}

int thisYear() {
  const auto today = std::chrono::floor<std::chrono::days>(std::chrono::system_clock::now());
  return static_cast<int>(std::chrono::year_month_day(today).year());
}

int fitMeasurements(const CalibrateArguments& arguments) {
  std::filesystem::path output = arguments.output;
  if (output.empty()) output = std::filesystem::path(arguments.table).replace_extension(".toml");
  requireReplaceable(output, {{arguments.table, "the table of measurements"},
                              {arguments.printer, "the printer file"},
                              {arguments.material, "the material file to start from"}});
  const Printer printer = readPrinter(arguments.printer);
  const PrintMaterial material = readPrintMaterial(arguments.material);
  const std::string table = arguments.table.string();
  const std::vector<Measurement> rows = readMeasurements(arguments.table);
  const CalibrationFit fit = fitCalibration(rows, table);
  const PrintMaterial fitted =
      fittedMaterial(material, fit, arguments.table.filename().string(), printer.name, thisYear());
  writeFileAtomically(output, printMaterialText(fitted));
  std::vector<std::string> notices = calibrationNotices(fit, table);
  if (const std::string notice = noticeOnHeights(rows, material); !notice.empty()) {
    notices.push_back(notice);
  }
  for (const std::string& notice : notices) spdlog::warn(visibleText(notice, "\n"));
  if (!arguments.isQuiet) {
    fmt::print("{}material in {}\n", calibrationTable(material, fit), output.string());
  }
  return kConverged;
}

void addTools(CLI::App& command, CalibrateArguments& arguments) {
  command
      .add_option("--printer", arguments.printer, "a printer file, e.g. printers/prusa_mk4.toml")
      ->required();
  command
      .add_option("--material", arguments.material,
                  "the material file to start from, e.g. materials/pla_0.08.toml")
      ->required();
}

void addSpecimens(CLI::App& calibrate, Action& action) {
  const auto arguments = std::make_shared<CalibrateArguments>();
  arguments->output = "out/calibration";
  CLI::App* command = calibrate.add_subcommand(
      "print", "G-code of specimens, a page that says what to do with them, a table to fill in");
  addTools(*command, *arguments);
  addHubOptions(*command, arguments->request);
  command->add_option("--out", arguments->output, "output folder")->capture_default_str();
  command->add_flag("--plain", arguments->isPlain, "leave out the comments that name struts");
  addQuietFlag(*command, arguments->isQuiet);
  command->callback([&action, arguments] { action = [=] { return printSpecimens(*arguments); }; });
}

void addFit(CLI::App& calibrate, Action& action) {
  const auto arguments = std::make_shared<CalibrateArguments>();
  CLI::App* command = calibrate.add_subcommand(
      "fit", "a material file from the table, filled in: least squares, with standard errors");
  command->add_option("FILE.csv", arguments->table, "measured.csv of `calibrate print`, filled in")
      ->required();
  addTools(*command, *arguments);
  command->add_option(
      "--out", arguments->output,
      "material file to write [beside FILE.csv, FILE.toml]; replaces none but those "
      "that this command wrote");
  addQuietFlag(*command, arguments->isQuiet);
  command->callback([&action, arguments] { action = [=] { return fitMeasurements(*arguments); }; });
}

}  // namespace

void addCalibrateCommand(CLI::App& app, Action& action) {
  CLI::App* command = app.add_subcommand(
      "calibrate", "what a bath does to a filament on a printer: specimens, and a fit");
  command->require_subcommand(1);
  addSpecimens(*command, action);
  addFit(*command, action);
}

}  // namespace morphgrid
