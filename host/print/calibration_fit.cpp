#include "print/calibration_fit.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <cmath>
#include <set>
#include <string_view>

#include "core/problem_list.h"
#include "print/robust_fit.h"

namespace morphgrid {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The law of mixing is doubted beyond so many standard errors, and this share of a free length:
/// rounding is no doubt.
constexpr double kDoubt = 3;
constexpr double kLeastDoubt = 1e-4;

/// Standard errors above which a fit is of no use, shares: a strut of 15 mm would be off by more
/// than the laying rounds.
constexpr double kMostError = 0.02;
constexpr double kMostHubError = 0.06;

/// What calipers and fingers are off by at most, mm: less is not doubted.
constexpr double kLengthReading = 0.5;
constexpr double kHeightReading = 0.15;

FittedValue valueOf(const LinearFit& fit, int n) { return {fit.values[n], fit.errors[n]}; }

/// Measurements as equations A x = b: a row each, lengths in mm.
struct Equations {
  MatrixXd a;  ///< By the changes that are sought.
  VectorXd b;  ///< After less before.
  std::vector<const Measurement*> rows;

  Equations(std::vector<const Measurement*> measured, int unknowns)
      : a(measured.size(), unknowns), b(measured.size()), rows(std::move(measured)) {}
};

template <typename IsMeant>
std::vector<const Measurement*> chosen(const std::vector<Measurement>& rows, IsMeant isMeant) {
  std::vector<const Measurement*> found;
  for (const Measurement& row : rows) {
    if (isMeant(row)) found.push_back(&row);
  }
  return found;
}

/// Notes what is farther from the others than a reading may be.
void doubt(const Equations& equations, int unknowns, const char* column, double reading,
           CalibrationFit& fit) {
  const MatrixXd a = equations.a.leftCols(unknowns);
  for (const auto& [row, expected] : outlyingRows(a, equations.b, reading)) {
    const Measurement& measured = *equations.rows[row];
    const bool isLength = column == std::string_view("length_after_mm");
    const double after = isLength ? *measured.lengthAfter : *measured.heightAfter;
    const double before = after - equations.b[row];
    fit.doubtful.push_back({measured.line, measured.specimen, column, after, before + expected});
  }
}

/// With a column for what half and half adds.
Equations equationsOf(std::vector<const Measurement*> chains) {
  Equations equations(std::move(chains), 4);
  for (Eigen::Index n = 0; n < equations.b.size(); ++n) {
    const Measurement& row = *equations.rows[n];
    const double free = row.struts * (row.pitch - row.hub);
    const double share = row.shareAlong;
    equations.a.row(n) << free * share, free * (1 - share), row.struts * row.hub,
        free * 4 * share * (1 - share);
    equations.b[n] = *row.lengthAfter - row.length();
  }
  return equations;
}

void fitChains(const std::vector<Measurement>& rows, CalibrationFit& fit) {
  const Equations equations = equationsOf(chosen(rows, [](const Measurement& row) {
    return row.kind == SpecimenKind::chain && row.lengthAfter;
  }));
  const auto found = fitLinear(equations.a.leftCols<3>(), equations.b);
  if (!found) {
    std::set<double> shares, pitches;
    for (const Measurement* row : equations.rows) {
      shares.insert(row->shareAlong);
      pitches.insert(row->pitch);
    }
    throw InputError(fmt::format(
        "length_after_mm is there for {} chains of {} shares laid along and {} pitches: it takes 4 "
        "chains at least, of 2 shares and 2 pitches",
        equations.rows.size(), shares.size(), pitches.size()));
  }
  fit.along = valueOf(*found, 0);
  fit.across = valueOf(*found, 1);
  fit.hub = valueOf(*found, 2);
  fit.chains = static_cast<int>(equations.rows.size());
  fit.chainDeviation = found->deviation;
  const auto mixed = fitLinear(equations.a, equations.b);
  if (mixed) fit.mixing = valueOf(*mixed, 3);
  doubt(equations, mixed ? 4 : 3, "length_after_mm", kLengthReading, fit);
}

/// Of struts laid like this.
std::optional<FittedValue> fitHeight(const std::vector<Measurement>& rows, double share,
                                     CalibrationFit& fit) {
  Equations equations(chosen(rows,
                             [&](const Measurement& row) {
                               return row.kind == SpecimenKind::chain && row.shareAlong == share &&
                                      row.heightAfter;
                             }),
                      1);
  for (Eigen::Index n = 0; n < equations.b.size(); ++n) {
    const Measurement& row = *equations.rows[n];
    equations.a(n, 0) = row.height;
    equations.b[n] = *row.heightAfter - row.height;
  }
  const auto found = fitLinear(equations.a, equations.b);
  if (!found) return std::nullopt;
  doubt(equations, 1, "height_after_mm", kHeightReading, fit);
  return valueOf(*found, 0);
}

/// Hub and tube, by stacks of different heights.
void fitTubes(const std::vector<Measurement>& rows, CalibrationFit& fit) {
  Equations equations(chosen(rows,
                             [](const Measurement& row) {
                               return row.kind == SpecimenKind::tubes && row.heightAfter;
                             }),
                      2);
  for (Eigen::Index n = 0; n < equations.b.size(); ++n) {
    const Measurement& row = *equations.rows[n];
    equations.a.row(n) << row.height, row.tube;
    equations.b[n] = *row.heightAfter - row.height - row.tube;
  }
  if (const auto found = fitLinear(equations.a, equations.b)) {
    fit.hubHeight = valueOf(*found, 0);
    fit.tube = valueOf(*found, 1);
    doubt(equations, 2, "height_after_mm", kHeightReading, fit);
  }
}

void findFlattest(const std::vector<Measurement>& rows, CalibrationFit& fit) {
  for (const Measurement& row : rows) {
    if (!row.isFlattest) continue;
    if (fit.flattestStep && *fit.flattestStep != row.heightStep) {
      throw InputError(
          fmt::format("specimens of height_step_mm {} and {} are both marked as flattest: mark one",
                      *fit.flattestStep, row.heightStep));
    }
    fit.flattestStep = row.heightStep;
  }
}

void requireUseful(const CalibrationFit& fit) {
  const auto check = [](const char* what, const FittedValue& value, double most) {
    if (value.error > most) {
      throw InputError(fmt::format(
          "{} come out {:+.2f} % +- {:.2f} %: a standard error above {:g} % is of no use. Measure "
          "again, or put - where a specimen was measured wrong",
          what, 100 * value.value, 100 * value.error, 100 * most));
    }
  };
  check("struts laid along", fit.along, kMostError);
  check("struts laid across", fit.across, kMostError);
  check("hubs", fit.hub, kMostHubError);
  if (fit.tube) check("tubes", *fit.tube, kMostHubError);
  if (fit.along.value >= fit.across.value) {
    throw InputError(fmt::format(
        "what is laid along comes out {:+.2f} %, what is laid across {:+.2f} %: along must shrink "
        "more. Are lengths in the wrong rows?",
        100 * fit.along.value, 100 * fit.across.value));
  }
}

}  // namespace

std::optional<LinearFit> fitLinear(const MatrixXd& a, const VectorXd& b) {
  const auto freedom = static_cast<int>(a.rows() - a.cols());
  if (freedom < 1) return std::nullopt;
  const Eigen::ColPivHouseholderQR<MatrixXd> qr(a);
  if (qr.rank() < a.cols()) return std::nullopt;
  LinearFit fit{.values = qr.solve(b), .freedom = freedom};
  fit.deviation = std::sqrt((a * fit.values - b).squaredNorm() / freedom);
  const MatrixXd inverse = (a.transpose() * a).inverse();
  fit.errors = fit.deviation * inverse.diagonal().cwiseSqrt();
  return fit;
}

bool CalibrationFit::mixes() const {
  return !mixing || std::abs(mixing->value) <= std::max(kLeastDoubt, kDoubt * mixing->error);
}

CalibrationFit fitCalibration(const std::vector<Measurement>& rows, const std::string& table) {
  CalibrationFit fit;
  try {
    fitChains(rows, fit);
    fit.alongHeight = fitHeight(rows, 1, fit);
    fit.acrossHeight = fitHeight(rows, 0, fit);
    fitTubes(rows, fit);
    findFlattest(rows, fit);
    requireUseful(fit);
  } catch (const InputError& error) {
    throw errorAt({table}, error.what() + listDoubtful(fit, table));
  }
  return fit;
}

}  // namespace morphgrid
