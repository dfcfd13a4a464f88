#include "print/printer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/key_place.h"
#include "core/read_toml_key.h"
#include "print/gcode_template.h"

namespace morphgrid {
namespace {

using PrinterKey = TomlKey<Printer>;

PrinterKey positiveKey(const char* name, double Printer::*value, const char* unit,
                       const char* meaning) {
  return {.name = name, .value = numberKey(at(value), above(0)), .unit = unit, .meaning = meaning};
}

std::vector<PrinterKey> machineKeys() {
  return {{.name = "name",
           .value = textKey(at(&Printer::name)),
           .isRequired = true,
           .meaning = "What reports call it."},
          {.name = "flavour",
           .value = wordKey(at(&Printer::flavour), kFlavourWords),
           .meaning = "What its firmware understands."},
          {.name = "bed",
           .value = numberPairKey(at(&Printer::bedX), at(&Printer::bedY), above(0)),
           .unit = "mm",
           .isRequired = true,
           .meaning = "What can be printed on, along x and y; its corner is at 0, 0."},
          {.name = "height",
           .value = numberKey(at(&Printer::height), above(0)),
           .unit = "mm",
           .isRequired = true,
           .meaning = "How high the nozzle gets."},
          {.name = "margin",
           .value = numberKey(at(&Printer::margin), atLeast(kSkirtGap + 1)),
           .unit = "mm",
           .meaning = "Kept free along the bed's edge, for the line around a tier, 3 mm away from "
                      "it, and the line that fills the nozzle."},
          positiveKey("nozzle", &Printer::nozzle, "mm", "Its diameter."),
          positiveKey("filament_diameter", &Printer::filamentDiameter, "mm", ""),
          positiveKey("line_width", &Printer::lineWidth, "mm",
                      "Of each line; from the nozzle's diameter to 1.7 times that."),
          {.name = "layer_heights",
           .value = numberPairKey(at(&Printer::leastHeight), at(&Printer::largestHeight), above(0)),
           .unit = "mm",
           .meaning = "The lowest and the highest pass that the nozzle can lay."},
          {.name = "nozzle_clearance",
           .value = numberKey(at(&Printer::nozzleClearance), atLeast(0)),
           .unit = "mm",
           .meaning = "What may stand beside the nozzle, since fan and heater pass above. Tubes up "
                      "to it are printed row by row, higher ones pass by pass."}};
}

std::vector<PrinterKey> motionKeys() {
  return {positiveKey("first_layer_speed", &Printer::firstPassSpeed, "mm/s",
                      "Nothing in the first pass is faster."),
          positiveKey("travel_speed", &Printer::travelSpeed, "mm/s", "Where nothing is laid."),
          positiveKey("acceleration", &Printer::acceleration, "mm/s^2", "Where something is laid."),
          positiveKey("travel_acceleration", &Printer::travelAcceleration, "mm/s^2",
                      "Where nothing is; not of `\"klipper\"`, which has one for both."),
          {.name = "pressure_advance",
           .value = numberKey(at(&Printer::pressureAdvance), atLeast(0)),
           .unit = "s",
           .meaning = "Sent to the printer as `M900 K`, `SET_PRESSURE_ADVANCE` or `M572 S`; 0 "
                      "leaves what it has."},
          positiveKey(
              "jerk", &Printer::jerk, "mm/s",
              "A change of speed that needs no braking. It tells how long a print takes, and is "
              "not sent to the printer."),
          {.name = "retract",
           .value = numberKey(at(&Printer::retraction), atLeast(0)),
           .unit = "mm",
           .meaning = "Filament drawn back before a long travel."},
          positiveKey("retract_speed", &Printer::retractionSpeed, "mm/s", "How fast."),
          {.name = "lift",
           .value = numberKey(at(&Printer::lift), atLeast(0)),
           .unit = "mm",
           .meaning = "How much higher than a pass the nozzle travels to it."}};
}

std::vector<PrinterKey> templateKeys() {
  const std::string names =
      " `{bed}` and `{nozzle}` are temperatures, `{bed_x}` and `{bed_y}` the bed's size, `{z_end}` "
      "a height above what is printed.";
  return {{.name = "start",
           .value = textKey(at(&Printer::start)),
           .isRequired = true,
           .meaning = "G-code before the print; it must leave the printer hot, at home, in "
                      "absolute coordinates and with relative E (`M83`)." +
                      names},
          {.name = "end",
           .value = textKey(at(&Printer::end)),
           .isRequired = true,
           .meaning = "G-code after it."}};
}

void checkTemplate(TomlReader& reader, const char* key, const std::string& text) {
  for (const std::string& name : unknownPlaceholders(text, templateNames())) {
    reader.problems.add(reader.root().place(key),
                        fmt::format("{}: {{{}}} stands for nothing; there are {{{}}}", key, name,
                                    fmt::join(templateNames(), "}, {")));
  }
}

void checkPrinter(TomlReader& reader, const Printer& printer) {
  TomlSection root = reader.root();
  const double widest = 1.7 * printer.nozzle;
  if (printer.lineWidth < printer.nozzle || printer.lineWidth > widest) {
    reader.problems.add(root.place("line_width"),
                        fmt::format("line_width must be >= {:.4g} and <= {:.4g} with a nozzle of "
                                    "{:.4g} mm, got {:.4g}",
                                    printer.nozzle, widest, printer.nozzle, printer.lineWidth));
  }
  if (printer.leastHeight > printer.largestHeight || printer.largestHeight > printer.lineWidth) {
    reader.problems.add(root.place("layer_heights"),
                        fmt::format("layer_heights must be the lower and the higher of two, up to "
                                    "line_width, {:.4g}, got [{:.4g}, {:.4g}]",
                                    printer.lineWidth, printer.leastHeight, printer.largestHeight));
  }
  checkTemplate(reader, "start", printer.start);
  checkTemplate(reader, "end", printer.end);
}

}  // namespace

const std::vector<TomlKeySection<Printer>>& printerKeys() {
  static const std::vector<TomlKeySection<Printer>> kSections = [] {
    std::vector<PrinterKey> keys = machineKeys();
    for (const auto& more : {motionKeys(), templateKeys()}) {
      keys.insert(keys.end(), more.begin(), more.end());
    }
    return std::vector<TomlKeySection<Printer>>{{"", std::move(keys)}};
  }();
  return kSections;
}

Printer readPrinter(const std::filesystem::path& file) {
  TomlReader reader(file, parseToml(file));
  Printer printer;
  readSections(reader, printerKeys(), printer);
  if (reader.problems.empty()) checkPrinter(reader, printer);
  reader.reportUnknownKeys();
  reader.problems.throwIfAny();
  return printer;
}

}  // namespace morphgrid
