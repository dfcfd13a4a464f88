#include "inverse/print_scale.h"

#include <algorithm>
#include <cmath>

#include "inverse/lateral_rest.h"

namespace morphgrid {
namespace {

using Eigen::VectorXd;

// A few struts at a mesh's corners must not set the size of the whole sheet; inverse design finds
// other lengths for them.
constexpr double kOutliers = 0.01;
// Of the search, in natural logarithms: from a twentieth to twenty times as large.
constexpr double kReach = 3;
constexpr int kBisections = 60;

/// What all but a few exceed.
double usualLeast(VectorXd values) {
  std::sort(values.begin(), values.end());
  return values[std::lround(kOutliers * static_cast<double>(values.size() - 1))];
}

/// By how much more, on a scale of ratios, struts could shrink than they could shrink less.
double imbalanceAt(double scale, const VectorXd& rest, const VectorXd& printed,
                   const BoundsAtScale& boundsAt) {
  const ShrinkBounds bounds = boundsAt(scale);
  VectorXd more(rest.size());
  VectorXd less(rest.size());
  for (Eigen::Index n = 0; n < rest.size(); ++n) {
    const double length = scale * printed[n];
    const ShrinkRange range = bounds.at(length);
    more[n] = std::log(rest[n] / (length * (1 - range.most)));
    less[n] = std::log(length * (1 - range.least) / rest[n]);
  }
  return usualLeast(std::move(more)) - usualLeast(std::move(less));
}

}  // namespace

double choosePrintScale(const StrutGrid& stacked, const BoundsAtScale& boundsAt) {
  const LateralRest lateral(stacked.shape);
  const VectorXd rest = lateral.of(stacked);
  const VectorXd printed = lateral.lengthsAt(stacked.positions);
  double low = -kReach;
  double high = kReach;
  for (int step = 0; step < kBisections; ++step) {
    const double middle = (low + high) / 2;
    (imbalanceAt(std::exp(middle), rest, printed, boundsAt) > 0 ? low : high) = middle;
  }
  return std::exp((low + high) / 2);
}

}  // namespace morphgrid
