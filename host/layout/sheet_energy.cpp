#include "layout/sheet_energy.h"

#include <algorithm>
#include <cmath>

namespace morphgrid {
namespace {

using Eigen::Index;
using Eigen::Matrix2Xd;
using Eigen::VectorXd;

constexpr double kRangeWeight = 30;
// Of the mean of all bars: chooses among sizes that all fit.
constexpr double kMiddleWeight = 0.01;

constexpr int kRows = 4;
constexpr int kEnds = 6;  // (x, y, turn) of both joints.
using Rows = Eigen::Matrix<double, kRows, 1>;
using Jacobian = Eigen::Matrix<double, kRows, kEnds>;

/// What of a bar's share does not change.
struct Scale {
  double meanChord;
  double middleWeight;
};

double middleOf(const SheetBar& bar) { return std::sqrt(bar.shortest * bar.longest); }

/// The bar's terms, whose squares add up to its energy, and what they depend on.
Rows termsOf(const SheetBar& bar, const VectorXd& unknowns, const Scale& scale,
             Jacobian* jacobian) {
  const Eigen::Vector2d chord =
      unknowns.segment<2>(Index{3} * bar.to) - unknowns.segment<2>(Index{3} * bar.from);
  const double square = chord.squaredNorm();
  const double length = scale.meanChord * std::sqrt(square);
  const double direction = std::atan2(chord.y(), chord.x());
  const double a = wrapped(direction - bar.directionFrom - unknowns[Index{3} * bar.from + 2]);
  const double b = wrapped(direction - bar.directionTo - unknowns[Index{3} * bar.to + 2]);
  const double bending = std::sqrt(scale.meanChord / (2 * bar.chord));
  const double shear = std::sqrt(3.0) * bending;
  const double range = std::sqrt(kRangeWeight);
  const double nearest = std::clamp(length, bar.shortest, bar.longest);
  if (jacobian) {
    const Eigen::RowVector2d turning(-chord.y() / square, chord.x() / square);
    const Eigen::RowVector2d stretching = chord.transpose() / square;
    jacobian->setZero();
    const auto moveBy = [&](int row, const Eigen::RowVector2d& byChord) {
      jacobian->block<1, 2>(row, 0) = -byChord;
      jacobian->block<1, 2>(row, 3) = byChord;
    };
    (*jacobian)(0, 2) = -bending;
    (*jacobian)(0, 5) = bending;
    moveBy(1, 2 * shear * turning);
    (*jacobian)(1, 2) = (*jacobian)(1, 5) = -shear;
    if (nearest != length) moveBy(2, range * stretching);
    moveBy(3, scale.middleWeight * stretching);
  }
  return {bending * (a - b), shear * (a + b), range * std::log(length / nearest),
          scale.middleWeight * std::log(length / middleOf(bar))};
}

double meanChordOf(const std::vector<SheetBar>& bars) {
  double sum = 0;
  for (const SheetBar& bar : bars) sum += bar.chord;
  return sum / static_cast<double>(bars.size());
}

}  // namespace

SheetEnergy::SheetEnergy(const SheetProblem& problem)
    : bars_(sheetBars(problem)), joints_(problem.layer.layerVertexCount()) {
  meanChord_ = meanChordOf(bars_);
}

double SheetEnergy::enlargement(const Matrix2Xd& positions) const {
  double logarithms = 0;
  for (const SheetBar& bar : bars_) {
    logarithms +=
        std::log(middleOf(bar) / (positions.col(bar.to) - positions.col(bar.from)).norm());
  }
  return std::exp(logarithms / static_cast<double>(bars_.size()));
}

VectorXd SheetEnergy::unknownsAt(const Matrix2Xd& positions) const {
  Matrix2Xd headings = Matrix2Xd::Zero(2, joints_);
  for (const SheetBar& bar : bars_) {
    const Eigen::Vector2d chord = positions.col(bar.to) - positions.col(bar.from);
    const double direction = std::atan2(chord.y(), chord.x());
    const auto add = [&](int joint, double turn) {
      headings.col(joint) += Eigen::Vector2d(std::cos(turn), std::sin(turn));
    };
    add(bar.from, direction - bar.directionFrom);
    add(bar.to, direction - bar.directionTo);
  }
  VectorXd unknowns(3 * joints_);
  for (Index n = 0; n < joints_; ++n) {
    unknowns.segment<2>(3 * n) = positions.col(n) / meanChord_;
    unknowns[3 * n + 2] = std::atan2(headings(1, n), headings(0, n));
  }
  return unknowns;
}

Matrix2Xd SheetEnergy::positionsOf(const VectorXd& unknowns) const {
  return meanChord_ * Eigen::Map<const Eigen::Matrix3Xd>(unknowns.data(), 3, joints_).topRows<2>();
}

double SheetEnergy::evaluate(const VectorXd& unknowns) const {
  const Scale scale{meanChord_, std::sqrt(kMiddleWeight / static_cast<double>(bars_.size()))};
  double energy = 0;
  for (const SheetBar& bar : bars_) {
    energy += termsOf(bar, unknowns, scale, nullptr).squaredNorm();
  }
  return energy;
}

SheetEnergy::Derivatives SheetEnergy::differentiate(const VectorXd& unknowns) const {
  const Scale scale{meanChord_, std::sqrt(kMiddleWeight / static_cast<double>(bars_.size()))};
  Derivatives result{VectorXd::Zero(unknowns.size()), {unknowns.size(), unknowns.size()}};
  std::vector<Eigen::Triplet<double>> entries;
  entries.reserve(bars_.size() * kEnds * (kEnds + 1) / 2);
  Jacobian jacobian;
  for (const SheetBar& bar : bars_) {
    const Rows terms = termsOf(bar, unknowns, scale, &jacobian);
    const Eigen::Matrix<double, kEnds, kEnds> block = jacobian.transpose() * jacobian;
    const Eigen::Matrix<double, kEnds, 1> slope = jacobian.transpose() * terms;
    const auto unknown = [&](int n) { return 3 * (n < 3 ? bar.from : bar.to) + n % 3; };
    for (int column = 0; column < kEnds; ++column) {
      result.gradient[unknown(column)] += slope[column];
      for (int row = column; row < kEnds; ++row) {
        entries.emplace_back(unknown(row), unknown(column), block(row, column));
      }
    }
  }
  result.hessian.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace morphgrid
