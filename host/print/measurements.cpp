#include "print/measurements.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "print/measurement_columns.h"

namespace morphgrid {
namespace {

constexpr const char* kComments =
    "# Lengths in mm. Measure after the bath and fill in the columns length_after_mm and "
    "height_after_mm\n"
    "# wherever they are empty; - is not measured. calibration.html says how.\n"
    "# Mark the specimen that lies flattest with x in the column flattest.\n";

/// Lengths as the table has them: to 0.1 micrometres.
double inTable(double length) { return std::round(length * 1e4) / 1e4; }

Measurement rowOf(const CalibrationPlate& plate, const Specimen& specimen) {
  return {.specimen = fmt::format("{}", specimen.number),
          .kind = specimen.kind,
          .struts = specimen.struts,
          .pitch = specimen.pitch,
          .shareAlong = specimen.shareAlong,
          .heightStep = specimen.heightStep,
          .hub = inTable(plate.plan.hub.diameter),
          .height = inTable(plate.plan.heights.strut)};
}

}  // namespace

std::vector<Measurement> rowsOf(const CalibrationPlate& plate) {
  std::vector<Measurement> rows;
  for (const Specimen& specimen : plate.specimens) {
    if (specimen.tubes.empty()) rows.push_back(rowOf(plate, specimen));
    for (std::size_t hub = 0; hub < specimen.tubes.size(); ++hub) {
      Measurement row = rowOf(plate, specimen);
      row.specimen += static_cast<char>('a' + hub);
      row.tube = inTable(specimen.tubes[hub]);
      rows.push_back(row);
    }
  }
  return rows;
}

std::string measurementsText(const std::vector<Measurement>& rows) {
  std::vector<std::string> names;
  for (const MeasurementColumn& column : measurementColumns()) names.emplace_back(column.name);
  std::string text = fmt::format("{}{}\n", kComments, fmt::join(names, ","));
  for (const Measurement& row : rows) {
    std::vector<std::string> cells;
    for (const MeasurementColumn& column : measurementColumns()) cells.push_back(column.text(row));
    text += fmt::format("{}\n", fmt::join(cells, ","));
  }
  return text;
}

}  // namespace morphgrid
