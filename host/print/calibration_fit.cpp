#include "print/calibration_fit.h"

#include <fmt/format.h>

#include <Eigen/QR>
#include <cmath>
#include <set>

#include "core/error.h"

namespace morphgrid {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// The law of mixing is doubted beyond so many standard errors, and this share of a free length:
/// rounding is no doubt.
constexpr double kDoubt = 3;
constexpr double kLeastDoubt = 1e-4;

FittedValue valueOf(const LinearFit& fit, int n) { return {fit.values[n], fit.errors[n]}; }

/// Chains as equations: a row each, lengths in mm. With a column for what half and half adds.
struct ChainEquations {
  MatrixXd a;  ///< By the changes along, across, of hubs, and the deviation from mixing.
  VectorXd b;  ///< After less before.
};

ChainEquations equationsOf(const std::vector<Measurement>& chains) {
  const auto count = static_cast<Eigen::Index>(chains.size());
  ChainEquations equations{MatrixXd(count, 4), VectorXd(count)};
  for (Eigen::Index n = 0; n < count; ++n) {
    const Measurement& row = chains[n];
    const double free = row.struts * (row.pitch - row.hub);
    const double share = row.shareAlong;
    equations.a.row(n) << free * share, free * (1 - share), row.struts * row.hub,
        free * 4 * share * (1 - share);
    equations.b[n] = *row.lengthAfter - row.length();
  }
  return equations;
}

void fitChains(const std::vector<Measurement>& rows, CalibrationFit& fit) {
  std::vector<Measurement> chains;
  std::set<double> shares, pitches;
  for (const Measurement& row : rows) {
    if (row.kind != SpecimenKind::chain || !row.lengthAfter) continue;
    chains.push_back(row);
    shares.insert(row.shareAlong);
    pitches.insert(row.pitch);
  }
  const ChainEquations equations = equationsOf(chains);
  const auto found = fitLinear(equations.a.leftCols<3>(), equations.b);
  if (!found) {
    throw InputError(fmt::format(
        "length_after_mm is there for {} chains of {} shares laid along and {} pitches: it takes 4 "
        "chains at least, of 2 shares and 2 pitches",
        chains.size(), shares.size(), pitches.size()));
  }
  fit.along = valueOf(*found, 0);
  fit.across = valueOf(*found, 1);
  fit.hub = valueOf(*found, 2);
  fit.chains = static_cast<int>(chains.size());
  fit.chainDeviation = found->deviation;
  if (const auto mixed = fitLinear(equations.a, equations.b)) fit.mixing = valueOf(*mixed, 3);
}

/// Of struts laid like this.
std::optional<FittedValue> fitHeight(const std::vector<Measurement>& rows, double share) {
  std::vector<double> changes;
  for (const Measurement& row : rows) {
    const bool isMeant = row.kind == SpecimenKind::chain && row.shareAlong == share;
    if (isMeant && row.heightAfter) changes.push_back(*row.heightAfter / row.height - 1);
  }
  const Eigen::Map<const VectorXd> b(changes.data(), static_cast<Eigen::Index>(changes.size()));
  const auto found = fitLinear(VectorXd::Ones(b.size()), b);
  return found ? std::optional(valueOf(*found, 0)) : std::nullopt;
}

/// Hub and tube, by stacks of different heights.
void fitTubes(const std::vector<Measurement>& rows, CalibrationFit& fit) {
  std::vector<const Measurement*> stacks;
  for (const Measurement& row : rows) {
    if (row.kind == SpecimenKind::tubes && row.heightAfter) stacks.push_back(&row);
  }
  const auto count = static_cast<Eigen::Index>(stacks.size());
  MatrixXd a(count, 2);
  VectorXd b(count);
  for (Eigen::Index n = 0; n < count; ++n) {
    const Measurement& row = *stacks[n];
    a.row(n) << row.height, row.tube;
    b[n] = *row.heightAfter - row.height - row.tube;
  }
  if (const auto found = fitLinear(a, b)) {
    fit.hubHeight = valueOf(*found, 0);
    fit.tube = valueOf(*found, 1);
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

CalibrationFit fitCalibration(const std::vector<Measurement>& rows) {
  CalibrationFit fit;
  fitChains(rows, fit);
  fit.alongHeight = fitHeight(rows, 1);
  fit.acrossHeight = fitHeight(rows, 0);
  fitTubes(rows, fit);
  findFlattest(rows, fit);
  if (fit.along.value >= fit.across.value) {
    throw InputError(fmt::format(
        "what is laid along comes out {:+.2f} %, what is laid across {:+.2f} %: along must shrink "
        "more. Are lengths in the wrong rows?",
        100 * fit.along.value, 100 * fit.across.value));
  }
  return fit;
}

}  // namespace morphgrid
