#include "print/printer.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <initializer_list>

#include "core/key_place.h"
#include "core/read_toml_key.h"
#include "print/gcode_template.h"
#include "print/print_file_kind.h"

namespace morphgrid {
namespace {

using PrinterKey = TomlKey<Printer>;

// Wide enough for any printer that lays filament; beyond them lies a slip of the pen.
constexpr NumberRange kBedSizes = fromTo(10, 1e4);
constexpr NumberRange kLineWidths = fromTo(0.1, 3);
constexpr NumberRange kPassHeights = fromTo(0.01, 2);
constexpr NumberRange kSpeeds = fromTo(1, 1000);
constexpr NumberRange kAccelerations = fromTo(10, 1e5);

PrinterKey rangeKey(const char* name, double Printer::*value, const NumberRange& range,
                    const char* unit, const char* meaning) {
  return {.name = name, .value = numberKey(at(value), range), .unit = unit, .meaning = meaning};
}

std::vector<PrinterKey> machineKeys() {
  return {
      {.name = "name",
       .value = textKey(at(&Printer::name)),
       .isRequired = true,
       .meaning = "What reports call it."},
      {.name = "flavour",
       .value = wordKey(at(&Printer::flavour), kFlavourWords),
       .meaning = "What its firmware understands."},
      {.name = "bed",
       .value = numberPairKey(at(&Printer::bedX), at(&Printer::bedY), kBedSizes),
       .unit = "mm",
       .isRequired = true,
       .meaning = "What can be printed on, along x and y; its corner is at 0, 0."},
      {.name = "height",
       .value = numberKey(at(&Printer::height), fromTo(1, 1e4)),
       .unit = "mm",
       .isRequired = true,
       .meaning = "How high the nozzle gets."},
      {.name = "margin",
       .value = numberKey(at(&Printer::margin), fromTo(kSkirtGap + 1, 1000)),
       .unit = "mm",
       .meaning = "Kept free along the bed's edge, for the line around a tier, 3 mm away from "
                  "it, and the line that fills the nozzle."},
      rangeKey("nozzle", &Printer::nozzle, fromTo(0.1, 2), "mm", "Its diameter."),
      rangeKey("filament_diameter", &Printer::filamentDiameter, fromTo(1, 4), "mm", ""),
      rangeKey("line_width", &Printer::lineWidth, kLineWidths, "mm",
               "Of each line; from the nozzle's diameter to 1.7 times that."),
      {.name = "layer_heights",
       .value = numberPairKey(at(&Printer::leastHeight), at(&Printer::largestHeight), kPassHeights),
       .unit = "mm",
       .meaning = "The lowest and the highest pass that the nozzle can lay."},
      rangeKey("nozzle_clearance", &Printer::nozzleClearance, fromTo(0, 100), "mm",
               "What may stand beside the nozzle, since fan and heater pass above. Tubes up to "
               "it are printed row by row, higher ones pass by pass.")};
}

std::vector<PrinterKey> motionKeys() {
  return {
      rangeKey("first_layer_speed", &Printer::firstPassSpeed, kSpeeds, "mm/s",
               "Nothing in the first pass is faster."),
      rangeKey("travel_speed", &Printer::travelSpeed, kSpeeds, "mm/s", "Where nothing is laid."),
      rangeKey("acceleration", &Printer::acceleration, kAccelerations, "mm/s^2",
               "Where something is laid."),
      rangeKey("travel_acceleration", &Printer::travelAcceleration, kAccelerations, "mm/s^2",
               "Where nothing is; not of `\"klipper\"`, which has one for both."),
      rangeKey("pressure_advance", &Printer::pressureAdvance, fromTo(0, 5), "s",
               "Sent to the printer as `M900 K`, `SET_PRESSURE_ADVANCE` or `M572 S`; 0 leaves "
               "what it has."),
      rangeKey("jerk", &Printer::jerk, fromTo(0.1, 100), "mm/s",
               "A change of speed that needs no braking. It tells how long a print takes, and "
               "is not sent to the printer."),
      rangeKey("retract", &Printer::retraction, fromTo(0, 50), "mm",
               "Filament drawn back before a long travel."),
      rangeKey("retract_speed", &Printer::retractionSpeed, fromTo(1, 500), "mm/s", "How fast."),
      rangeKey("lift", &Printer::lift, fromTo(0, 20), "mm",
               "How much higher than a pass the nozzle travels to it.")};
}

std::vector<PrinterKey> templateKeys() {
  const std::string names =
      " `{bed}` and `{nozzle}` are temperatures, `{bed_x}` and `{bed_y}` the bed's size, `{z_end}` "
      "a height above what is printed.";
  return {{.name = "start",
           .value = textKey(at(&Printer::start)),
           .isRequired = true,
           .meaning = "G-code before the print; it must leave the printer hot, at home, in "
                      "absolute coordinates and, after the last `M82`, or `G90` of Marlin, with "
                      "relative E (`M83`)." +
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

/// What follows gives each E from the last one on, and X, Y and Z from the bed's corner.
void checkStart(TomlReader& reader, const Printer& printer) {
  const std::vector<std::string> commands = commandsIn(printer.start);
  const auto last = [&](std::initializer_list<const char*> names) -> std::string {
    const auto found =
        std::find_first_of(commands.rbegin(), commands.rend(), names.begin(), names.end());
    return found == commands.rend() ? "" : *found;
  };
  const auto refuse = [&](const std::string& what) {
    reader.problems.add(reader.root().place("start"), "start " + what);
  };
  // Marlin's G90 and G91 are for E too.
  const std::string mode = printer.flavour == Flavour::marlin ? last({"M82", "M83", "G90", "G91"})
                                                              : last({"M82", "M83"});
  if (mode != "M83") {
    refuse(mode.empty() ? "must hold M83, on a line of its own: what follows has relative E"
                        : fmt::format("makes E absolute by its last {}, but what follows has "
                                      "relative E: put M83 behind it, on a line of its own",
                                      mode));
  }
  if (last({"G90", "G91"}) == "G91") {
    refuse(
        "makes coordinates relative by its last G91, but what follows has absolute ones: put "
        "G90, then M83, behind it");
  }
}

void checkMargin(TomlReader& reader, const Printer& printer) {
  if (2 * printer.margin < std::min(printer.bedX, printer.bedY)) return;
  reader.problems.add(reader.root().place("margin"),
                      fmt::format("margin leaves nothing of the bed of {:g} x {:g} mm, got {:g}",
                                  printer.bedX, printer.bedY, printer.margin));
}

void checkPrinter(TomlReader& reader, const Printer& printer) {
  TomlSection root = reader.root();
  checkMargin(reader, printer);
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
  checkStart(reader, printer);
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
  requireKind(PrintFileKind::printer, file, reader.document());
  Printer printer;
  readSections(reader, printerKeys(), printer);
  if (reader.problems.empty()) checkPrinter(reader, printer);
  reader.reportUnknownKeys();
  reader.problems.throwIfAny();
  return printer;
}

}  // namespace morphgrid
