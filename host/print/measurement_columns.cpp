#include "print/measurement_columns.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace morphgrid {
namespace {

/// A number with a decimal point or, since some spreadsheets write those, comma.
std::optional<double> numberIn(std::string cell) {
  std::replace(cell.begin(), cell.end(), ',', '.');
  const char* begin = cell.data() + (cell[0] == '+' ? 1 : 0);
  const char* end = cell.data() + cell.size();
  double value = 0;
  const auto result = std::from_chars(begin, end, value);
  return result.ec == std::errc() && result.ptr == end ? std::optional(value) : std::nullopt;
}

/// -, or nothing.
bool isNotMeasured(const std::string& cell) { return cell.empty() || cell == "-"; }

MeasurementColumn numberColumn(const char* name, double Measurement::*value,
                               const NumberRange& range) {
  return {name, true, false, [=](const Measurement& row) { return fmt::format("{}", row.*value); },
          [=](const std::string& cell, Measurement& row) -> std::string {
            const auto number = numberIn(cell);
            if (!number || !range.contains(*number)) return describe(range);
            row.*value = *number;
            return "";
          }};
}

/// Ranges that depend on what was printed are checked when the row has been read.
MeasurementColumn measuredColumn(const char* name, std::optional<double> Measurement::*value,
                                 bool (*isAsked)(const Measurement&)) {
  return {name, true, true,
          [=](const Measurement& row) {
            if (row.*value) return fmt::format("{}", *(row.*value));
            return std::string(isAsked(row) ? "" : "-");
          },
          [=](const std::string& cell, Measurement& row) -> std::string {
            if (isNotMeasured(cell)) return "";
            row.*value = numberIn(cell);
            return row.*value ? "" : "a number of mm, or - where it was not measured";
          }};
}

MeasurementColumn strutsColumn() {
  return {"struts", true, false,
          [](const Measurement& row) { return fmt::format("{}", row.struts); },
          [](const std::string& cell, Measurement& row) -> std::string {
            const auto number = numberIn(cell);
            constexpr IntegerRange kRange{1, 1000};
            if (!number || *number != std::floor(*number) || *number < 1 || *number > 1000) {
              return describe(kRange);
            }
            row.struts = static_cast<int>(*number);
            return "";
          }};
}

MeasurementColumn kindColumn() {
  return {"kind", true, false,
          [](const Measurement& row) {
            return std::string(kSpecimenWords[static_cast<std::size_t>(row.kind)]);
          },
          [](const std::string& cell, Measurement& row) -> std::string {
            const auto* const word = std::find(kSpecimenWords.begin(), kSpecimenWords.end(), cell);
            if (word == kSpecimenWords.end()) {
              return fmt::format("{}", fmt::join(kSpecimenWords, " or "));
            }
            row.kind = static_cast<SpecimenKind>(word - kSpecimenWords.begin());
            return "";
          }};
}

MeasurementColumn flattestColumn() {
  return {"flattest", false, true,
          [](const Measurement& row) { return std::string(row.isFlattest ? "x" : ""); },
          [](const std::string& cell, Measurement& row) -> std::string {
            row.isFlattest = cell == "x" || cell == "X";
            return row.isFlattest || isNotMeasured(cell) ? "" : "x, or nothing";
          }};
}

}  // namespace

NumberRange afterBath(double printed) { return fromTo(0.2 * printed, 4 * printed); }

const std::vector<MeasurementColumn>& measurementColumns() {
  using Row = Measurement;
  const auto specimenText = [](const Row& row) { return row.specimen; };
  const auto readSpecimen = [](const std::string& cell, Row& row) -> std::string {
    row.specimen = cell;
    return "";
  };
  static const std::vector<MeasurementColumn> kColumns{
      {"specimen", true, false, specimenText, readSpecimen},
      kindColumn(),
      strutsColumn(),
      numberColumn("pitch_mm", &Row::pitch, above(0)),
      numberColumn("share_along", &Row::shareAlong, fromTo(0, 1)),
      numberColumn("height_step_mm", &Row::heightStep, NumberRange()),
      numberColumn("hub_mm", &Row::hub, above(0)),
      numberColumn("tube_mm", &Row::tube, atLeast(0)),
      numberColumn("height_mm", &Row::height, above(0)),
      measuredColumn("length_after_mm", &Row::lengthAfter,
                     [](const Row& row) { return row.kind == SpecimenKind::chain; }),
      // A strut that is laid half and half has no one height.
      measuredColumn("height_after_mm", &Row::heightAfter,
                     [](const Row& row) {
                       return row.kind == SpecimenKind::tubes ||
                              (row.kind == SpecimenKind::chain &&
                               (row.shareAlong == 0 || row.shareAlong == 1));
                     }),
      flattestColumn()};
  return kColumns;
}

}  // namespace morphgrid
