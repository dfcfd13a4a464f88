#include "print/robust_fit.h"

#include <Eigen/QR>
#include <algorithm>

#include "print/print_tolerance.h"

namespace morphgrid {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

/// Of the scatter, as one sigma: of 1000 rows with normal errors none is farther.
constexpr double kOutlying = 5;
/// The median of |error| over sigma, for normal errors.
constexpr double kMedianOfSigma = 0.6745;

/// b - A x with the least sum of absolute values, by iteratively reweighted least squares.
VectorXd leastAbsoluteResiduals(const MatrixXd& a, const VectorXd& b) {
  constexpr int kRounds = 50;
  const double nothing = 1e-9 * (1 + b.cwiseAbs().maxCoeff());
  VectorXd residuals = b;
  VectorXd weights = VectorXd::Ones(b.size());
  for (int round = 0; round < kRounds; ++round) {
    const VectorXd x =
        (weights.asDiagonal() * a).colPivHouseholderQr().solve(weights.cwiseProduct(b));
    residuals = b - a * x;
    weights = residuals.cwiseAbs().cwiseMax(nothing).cwiseInverse().cwiseSqrt();
  }
  return residuals;
}

/// One sigma of rows that fit. As many rows as unknowns are met exactly and say nothing.
double scatterOf(const VectorXd& residuals, Eigen::Index unknowns) {
  std::vector<double> sizes(residuals.size());
  VectorXd::Map(sizes.data(), residuals.size()) = residuals.cwiseAbs();
  std::sort(sizes.begin(), sizes.end());
  sizes.erase(sizes.begin(), sizes.begin() + unknowns);
  return quantileOf(std::move(sizes), 0.5) / kMedianOfSigma;
}

}  // namespace

std::vector<OutlyingRow> outlyingRows(const MatrixXd& a, const VectorXd& b, double least) {
  const VectorXd residuals = leastAbsoluteResiduals(a, b);
  const double far = std::max(least, kOutlying * scatterOf(residuals, a.cols()));
  std::vector<OutlyingRow> rows;
  for (Eigen::Index row = 0; row < b.size(); ++row) {
    if (std::abs(residuals[row]) > far) rows.push_back({row, b[row] - residuals[row]});
  }
  std::sort(rows.begin(), rows.end(), [&](const OutlyingRow& one, const OutlyingRow& other) {
    return std::abs(residuals[one.row]) > std::abs(residuals[other.row]);
  });
  return rows;
}

}  // namespace morphgrid
