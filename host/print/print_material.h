#pragma once
#include <algorithm>
#include <filesystem>
#include <string>

#include "core/toml_key.h"

namespace morphgrid {

/// How material is laid in a part of a strut, and what the bath does to it.
struct Lay {
  double speed = 30;        ///< mm/s
  double change = 0;        ///< Of length along the strut, as a share; below 0 it shrinks.
  double error = 0;         ///< Standard error of `change`; 0: not known. As those below.
  double heightChange = 0;  ///< As a share.

  bool operator==(const Lay&) const = default;
};

/// A filament, how it is printed, and how a bath of hot water changes what was printed so.
struct PrintMaterial {
  std::string name;
  std::string source;  ///< Where the changes come from.
  int year = 0;
  std::string caveat;           ///< Shown in every report.
  double density = 1.24;        ///< g/cm^3
  double glassTransition = 60;  ///< Degrees C, as the others.
  double bath = 80;
  double nozzleTemperature = 0;
  double bedTemperature = 0;
  double fan = 1;  ///< Share of its full speed.

  /// Of a strut, seen from above: lines beside each other; passes on top of each other.
  struct StrutPasses {
    int lines = 3;  ///< Odd.
    int passes = 0;
    double passHeight = 0;  ///< mm
    double heightStep = 0;  ///< mm by which a pass is higher than the one below.

    bool operator==(const StrutPasses&) const = default;
  } strut;
  Lay along;   ///< Lines along the strut: they shrink it most.
  Lay across;  ///< Lines across it: it shrinks least, or grows.

  /// The rings at vertices, which a pin goes through.
  struct HubRings {
    int every = 2;  ///< Passes from one to the next, which is that much higher.
    double speed = 20;
    double change = 0;  ///< Of the diameter, as a share.
    double error = 0;
    double heightChange = 0;
    bool isMeasured = false;

    bool operator==(const HubRings&) const = default;
  } hub;

  /// What carries hubs on to the tier above.
  struct TubeRings {
    double passHeight = 0.2;
    double speed = 20;
    double change = 0;  ///< Of the height, as a share.
    double error = 0;
    bool isMeasured = false;

    bool operator==(const TubeRings&) const = default;
  } tube;

  /// The height of pass n, from 0, mm.
  double heightOf(int pass) const {
    return strut.passHeight + strut.heightStep * (pass - (strut.passes - 1) / 2.0);
  }
  /// Of a strut as printed, mm.
  double strutHeight() const { return strut.passes * strut.passHeight; }
  /// The same after the bath: the higher of both lays.
  double strutHeightSwollen() const {
    return strutHeight() * (1 + std::max(along.heightChange, across.heightChange));
  }

  bool operator==(const PrintMaterial&) const = default;
};

/// All keys of material files, section by section: readPrintMaterial() and docs/printing_format.md
/// come from here.
const std::vector<TomlKeySection<PrintMaterial>>& printMaterialKeys();

/// A material file that reads as this one.
std::string printMaterialText(const PrintMaterial& material);

/// Throws InputError with every problem, one a line, each as `file:line:column: ...`.
PrintMaterial readPrintMaterial(const std::filesystem::path& file);

}  // namespace morphgrid
