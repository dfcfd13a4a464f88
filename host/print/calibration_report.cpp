#include <fmt/format.h>

#include <cmath>

#include "print/calibration_fit.h"

namespace morphgrid {
namespace {

constexpr const char* kCalibrated = ", calibrated";
constexpr const char* kFitSource = "a fit of own measurements, ";

std::string inPercent(const FittedValue& value) {
  return fmt::format("{:+.2f} +- {:.2f} %", 100 * value.value, 100 * value.error);
}

/// More decimals than a bath will ever show make a file hard to read.
double inFile(double share) { return std::round(share * 1e6) / 1e6; }

std::string measurements(std::size_t count) {
  return count == 1 ? "1 measurement is" : fmt::format("{} measurements are", count);
}

std::string caveatOf(const CalibrationFit& fit) {
  std::string text =
      fmt::format("One filament, one printer, one session; along {}, across {}, hubs {}",
                  inPercent(fit.along), inPercent(fit.across), inPercent(fit.hub));
  if (!fit.alongHeight || !fit.acrossHeight) text += "; growth of struts in height not measured";
  text += fit.tube ? fmt::format(", tubes {}", inPercent(*fit.tube))
                   : std::string("; growth of hubs and tubes in height not measured");
  if (!fit.mixes()) text += "; along and across do not add up";
  if (!fit.doubtful.empty()) {
    text += fmt::format("; {} far from the others", measurements(fit.doubtful.size()));
  }
  return text;
}

std::string fittedRow(const char* what, double before, const std::optional<FittedValue>& fitted) {
  if (!fitted) return fmt::format("  {:<26}{:+8.2f} %   not measured\n", what, 100 * before);
  return fmt::format("  {:<26}{:+8.2f} % {:+8.2f} % {:7.2f} % {:+8.2f} %\n", what, 100 * before,
                     100 * fitted->value, 100 * fitted->error, 100 * (fitted->value - before));
}

}  // namespace

PrintMaterial fittedMaterial(const PrintMaterial& material, const CalibrationFit& fit,
                             const std::string& table, const std::string& printer, int year) {
  PrintMaterial fitted = material;
  if (!material.name.ends_with(kCalibrated)) fitted.name += kCalibrated;
  fitted.source = fmt::format("{}{}, printed with {}", kFitSource, table, printer);
  fitted.year = year;
  fitted.caveat = caveatOf(fit);
  fitted.along.change = inFile(fit.along.value);
  fitted.along.error = inFile(fit.along.error);
  fitted.across.change = inFile(fit.across.value);
  fitted.across.error = inFile(fit.across.error);
  fitted.hub.change = inFile(fit.hub.value);
  fitted.hub.error = inFile(fit.hub.error);
  if (fit.alongHeight) fitted.along.heightChange = inFile(fit.alongHeight->value);
  if (fit.acrossHeight) fitted.across.heightChange = inFile(fit.acrossHeight->value);
  fitted.hub.isMeasured = fit.hubHeight.has_value();
  fitted.tube.isMeasured = fit.tube.has_value();
  if (fit.hubHeight) fitted.hub.heightChange = inFile(fit.hubHeight->value);
  if (fit.tube) {
    fitted.tube.change = inFile(fit.tube->value);
    fitted.tube.error = inFile(fit.tube->error);
  }
  if (fit.flattestStep) fitted.strut.heightStep = *fit.flattestStep;
  return fitted;
}

bool isFitted(const PrintMaterial& material) { return material.source.starts_with(kFitSource); }

std::string listDoubtful(const CalibrationFit& fit, const std::string& table) {
  std::string lines;
  for (const DoubtfulMeasurement& row : fit.doubtful) {
    lines += fmt::format("\n{}:{}: specimen {}: {} is {:.2f}, by the others it would be {:.2f}",
                         table, row.line, row.specimen, row.column, row.measured, row.expected);
  }
  return lines;
}

std::string noticeOnHeights(const std::vector<Measurement>& rows, const PrintMaterial& material) {
  constexpr double kSame = 1e-3;  // mm; tables have four decimals.
  for (const Measurement& row : rows) {
    if (std::abs(row.height - material.strutHeight()) <= kSame) continue;
    return fmt::format(
        "specimen {} was printed {:g} mm high, struts of {} are {:g} mm: give the material, and "
        "later print with the --passes, that specimens were printed with",
        row.specimen, row.height, material.name, material.strutHeight());
  }
  return "";
}

std::string calibrationTable(const PrintMaterial& before, const CalibrationFit& fit) {
  std::string text = fmt::format("{}, fitted\n  {:<26}{:>10} {:>10} {:>9} {:>10}\n", before.name,
                                 "change in the bath", "before", "fitted", "error", "differs");
  text += fittedRow("length, laid along", before.along.change, fit.along);
  text += fittedRow("length, laid across", before.across.change, fit.across);
  text += fittedRow("diameter of hubs", before.hub.change, fit.hub);
  text += fittedRow("height, laid along", before.along.heightChange, fit.alongHeight);
  text += fittedRow("height, laid across", before.across.heightChange, fit.acrossHeight);
  text += fittedRow("height of hubs", before.hub.heightChange, fit.hubHeight);
  text += fittedRow("height of tubes", before.tube.change, fit.tube);
  text += fmt::format("  {:<26}{}, each {:.3f} mm from the fit\n", "chains", fit.chains,
                      fit.chainDeviation);
  if (fit.mixing) {
    text += fmt::format("  {:<26}{} off the mean of both: {}\n", "half along, half across",
                        inPercent(*fit.mixing), fit.mixes() ? "they add up" : "they do not add up");
  }
  if (fit.flattestStep) {
    text += fmt::format("  {:<26}{:g} mm, before {:g} mm\n", "height_step, flattest",
                        *fit.flattestStep, before.strut.heightStep);
  }
  return text;
}

std::vector<std::string> calibrationNotices(const CalibrationFit& fit, const std::string& table) {
  std::vector<std::string> notices;
  if (!fit.doubtful.empty()) {
    notices.push_back(fmt::format(
        "{} far from what the others say, and counted all the same: right what was misread, or "
        "put - in its place{}",
        measurements(fit.doubtful.size()), listDoubtful(fit, table)));
  }
  if (!fit.mixes()) {
    notices.push_back(fmt::format(
        "struts laid half along, half across come out {} longer than the mean of both, more than "
        "three errors: shares between will be off by as much",
        inPercent(*fit.mixing)));
  }
  if (!fit.mixing) {
    notices.emplace_back(
        "no chain laid half along, half across was measured, or too few others: "
        "whether both add up is not known");
  }
  if (!fit.tube) {
    notices.emplace_back(
        "fewer than 3 tubes of 2 heights were measured: the growth of hubs and "
        "tubes stays that of the material");
  }
  if (!fit.alongHeight || !fit.acrossHeight) {
    notices.emplace_back(
        "the height of fewer than 2 chains laid along, or across, was measured: "
        "the growth of struts in height stays that of the material");
  }
  return notices;
}

}  // namespace morphgrid
