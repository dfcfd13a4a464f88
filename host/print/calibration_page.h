#pragma once
#include <filesystem>
#include <string>

#include "print/calibration_plate.h"

namespace morphgrid {

/// calibration.html: what to do with the specimens, and their map at 1:1. One file, which needs no
/// other.
std::string calibrationPage(const CalibrationPlate& plate, const TierFigures& figures);

/// Writes calibration.gcode, calibration.html and measured.csv into a folder that is there, all of
/// them or none, and returns what printing takes. Throws InputError when the specimens cannot be
/// laid, the disk refuses, or a measured.csv is there that somebody has filled in.
TierFigures writeCalibrationFiles(const CalibrationPlate& plate,
                                  const std::filesystem::path& folder, bool isPlain);

}  // namespace morphgrid
