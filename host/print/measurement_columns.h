#pragma once
#include <functional>

#include "print/measurements.h"

namespace morphgrid {

/// A column of measured.csv.
struct MeasurementColumn {
  const char* name;
  bool isRequired;  ///< The column must be there.
  bool mayBeEmpty;  ///< Its cells may.
  std::function<std::string(const Measurement&)> text;
  /// Puts the text of a cell, which is not empty, into a row; returns what is allowed where that
  /// will not do, else an empty text.
  std::function<std::string(const std::string& cell, Measurement&)> read;
};

/// All columns, in the order in which they are written; the one place that says what they are.
const std::vector<MeasurementColumn>& measurementColumns();

/// What measurements may be, of what was printed so large: a change within reason, so that a
/// misplaced decimal point is told.
NumberRange afterBath(double printed);

}  // namespace morphgrid
