#include "inverse/bounded_lbfgs.h"

#include <utility>
#include <vector>

namespace morphgrid {
namespace {

using Eigen::ArrayXd;
using Eigen::VectorXd;

constexpr std::size_t kRememberedPairs = 10;

}  // namespace

BoundedLbfgs::BoundedLbfgs(VectorXd low, VectorXd high)
    : low_(std::move(low)), high_(std::move(high)) {}

ArrayXd BoundedLbfgs::freedom(const VectorXd& x, const VectorXd& gradient) const {
  const auto held = (x.array() <= low_.array() && gradient.array() > 0) ||
                    (x.array() >= high_.array() && gradient.array() < 0);
  return 1 - held.cast<double>();
}

VectorXd BoundedLbfgs::direction(const VectorXd& x, const VectorXd& gradient,
                                 double firstStep) const {
  const ArrayXd free = freedom(x, gradient);
  VectorXd q = free * gradient.array();
  if (pairs_.empty()) {
    const double largest = q.cwiseAbs().maxCoeff();
    return largest > 0 ? VectorXd(-firstStep / largest * q) : q;
  }
  // The recursion among the free variables only: the others must not move.
  std::vector<double> weights(pairs_.size(), 0);
  std::vector<double> curvatures(pairs_.size(), 0);
  double scale = 1;
  for (std::size_t n = pairs_.size(); n-- > 0;) {
    const VectorXd s = free * pairs_[n].step.array();
    curvatures[n] = s.dot(pairs_[n].change);
    if (curvatures[n] <= 0) {
      continue;
    }
    weights[n] = s.dot(q) / curvatures[n];
    q -= weights[n] * VectorXd(free * pairs_[n].change.array());
  }
  for (std::size_t n = pairs_.size(); n-- > 0;) {
    if (curvatures[n] > 0) {
      scale = curvatures[n] / (free * pairs_[n].change.array()).square().sum();
      break;
    }
  }
  q *= scale;
  for (std::size_t n = 0; n < pairs_.size(); ++n) {
    if (curvatures[n] > 0) {
      const double beta = (free * pairs_[n].change.array() * q.array()).sum() / curvatures[n];
      q += (weights[n] - beta) * VectorXd(free * pairs_[n].step.array());
    }
  }
  return -q;
}

void BoundedLbfgs::add(const VectorXd& s, const VectorXd& y) {
  if (s.dot(y) <= 0) {
    return;
  }
  pairs_.push_back({s, y});
  if (pairs_.size() > kRememberedPairs) {
    pairs_.pop_front();
  }
}

}  // namespace morphgrid
