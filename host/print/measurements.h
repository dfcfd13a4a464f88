#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "print/calibration_plate.h"

namespace morphgrid {

/// A row of measured.csv: what was printed, and what was measured after the bath. Lengths in mm.
struct Measurement {
  int line = 0;          ///< Of the file.
  std::string specimen;  ///< Its number; of tubes with a letter for the hub.
  SpecimenKind kind = SpecimenKind::chain;
  int struts = 0;  ///< As printed, like what follows.
  double pitch = 0;
  double shareAlong = 0;
  double heightStep = 0;
  double hub = 0;                     ///< Diameter.
  double tube = 0;                    ///< Its height.
  double height = 0;                  ///< Of a strut or, of tubes, of the hub below.
  std::optional<double> lengthAfter;  ///< From hole to hole of the first and the last hub.
  std::optional<double> heightAfter;  ///< Of a strut or, of tubes, of hub and tube together.
  bool isFlattest = false;            ///< Marked by the user.

  double length() const { return struts * pitch; }
};

/// The rows of a plate, nothing measured.
std::vector<Measurement> rowsOf(const CalibrationPlate& plate);

/// measured.csv: comments that say what to fill in, the columns' names, the rows.
std::string measurementsText(const std::vector<Measurement>& rows);

/// Reads such a file, as spreadsheets write it, too: separated by commas, semicolons (then numbers
/// may have decimal commas) or tabs, columns in any order, `#` before comments. Throws InputError
/// with every problem, one a line, each as `file:line: ...`.
std::vector<Measurement> readMeasurements(const std::filesystem::path& file);

}  // namespace morphgrid
