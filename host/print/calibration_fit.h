#pragma once
#include <optional>
#include <vector>

#include "print/measurements.h"
#include "print/print_material.h"

namespace morphgrid {

/// With its standard error.
struct FittedValue {
  double value = 0;
  double error = 0;
};

/// Least squares of A x = b with equal errors of all b.
struct LinearFit {
  Eigen::VectorXd values;  ///< x
  Eigen::VectorXd errors;  ///< Standard errors of x, from the residuals.
  double deviation = 0;    ///< Of one b, from the residuals: sqrt(|A x - b|^2 / freedom).
  int freedom = 0;         ///< Rows less unknowns.
};

/// a: m x n of full rank, m > n; nothing when it is not.
std::optional<LinearFit> fitLinear(const Eigen::MatrixXd& a, const Eigen::VectorXd& b);

/// A measurement far from what the others make of it. Lengths in mm.
struct DoubtfulMeasurement {
  int line = 0;  ///< Of the table.
  std::string specimen;
  std::string column;
  double measured = 0;
  double expected = 0;
};

/// What a bath does to struts, hubs and tubes, by measurements of a plate. Changes are shares,
/// below 0 where something shrinks; nothing where too little was measured.
struct CalibrationFit {
  FittedValue along, across, hub;
  int chains = 0;
  double chainDeviation = 0;  ///< Of a chain's length, mm.
  /// By how much a strut laid half and half loses less, a share of its free length, than the mean
  /// of one laid along and one laid across.
  std::optional<FittedValue> mixing;
  std::optional<FittedValue> alongHeight, acrossHeight, hubHeight, tube;
  std::optional<double> flattestStep;         ///< mm, where one was marked.
  std::vector<DoubtfulMeasurement> doubtful;  ///< The farthest of each column first.

  bool mixes() const;  ///< The law of mixing holds, as far as the measurements tell.
};

/// n struts of pitch P whose hubs have the diameter D come out n ((P - D) (1 + f a + (1 - f) c) +
/// D (1 + b)) long, a, c and b the changes of what is laid along, across and of hubs. Rows of one
/// specimen count each. table: the file, which errors name. Throws InputError, with what is missing
/// or doubtful, when the measurements do not tell them, scatter so that their standard errors make
/// them useless, or contradict what a material must be.
CalibrationFit fitCalibration(const std::vector<Measurement>& rows, const std::string& table = "");

/// The material with what was fitted in place of its own, and what it is told to be. table: the
/// file's name; year: of the measurements.
PrintMaterial fittedMaterial(const PrintMaterial& material, const CalibrationFit& fit,
                             const std::string& table, const std::string& printer, int year);

/// Whether a material is one that fittedMaterial() made.
bool isFitted(const PrintMaterial& material);

/// What was fitted, beside the material that it started from: a table for the terminal.
std::string calibrationTable(const PrintMaterial& before, const CalibrationFit& fit);

/// What whoever uses the fit should know. table: the file.
std::vector<std::string> calibrationNotices(const CalibrationFit& fit, const std::string& table);

/// A line for each measurement that is far from the others: `table:line: ...`, each after a break.
std::string listDoubtful(const CalibrationFit& fit, const std::string& table);

/// Says so where specimens are not as high as the material's struts; empty where all are.
std::string noticeOnHeights(const std::vector<Measurement>& rows, const PrintMaterial& material);

}  // namespace morphgrid
