#pragma once
#include <array>
#include <filesystem>
#include <string>

#include "core/number_range.h"
#include "core/toml_key.h"

namespace morphgrid {

/// The dialect of G-code that a printer's firmware understands.
enum class Flavour { marlin, klipper, rrf };
inline constexpr std::array kFlavourWords = {"marlin", "klipper", "rrf"};

/// What G-code has to know of a printer. Lengths in mm, speeds in mm/s, accelerations in mm/s^2.
struct Printer {
  std::string name;
  Flavour flavour = Flavour::marlin;
  double bedX = 0;
  double bedY = 0;
  double height = 0;
  double margin = 5;  ///< Kept free along the bed's edge, for the skirt and the purge line.
  double nozzle = 0.4;
  double filamentDiameter = 1.75;
  double lineWidth = 0.45;
  double leastHeight = 0.05;  ///< Of a pass.
  double largestHeight = 0.3;
  double firstPassSpeed = 15;
  double travelSpeed = 150;
  double acceleration = 1000;
  double travelAcceleration = 2000;
  double jerk = 8;             ///< Of how long a print takes, no more: firmware has its own.
  double pressureAdvance = 0;  ///< s; 0: the printer's own.
  double retraction = 0.7;
  double retractionSpeed = 35;
  double lift = 0.2;
  double nozzleClearance = 2.5;  ///< How high what is printed may stand beside the nozzle.
  std::string start;             ///< G-code with placeholders, see fillTemplate().
  std::string end;

  bool operator==(const Printer&) const = default;
};

/// How far the line around a tier stays away from it, mm.
inline constexpr double kSkirtGap = 3;

/// All keys of printer files, section by section: readPrinter() and docs/printing_format.md come
/// from here.
const std::vector<TomlKeySection<Printer>>& printerKeys();

/// Throws InputError with every problem, one a line, each as `file:line:column: ...`.
Printer readPrinter(const std::filesystem::path& file);

}  // namespace morphgrid
