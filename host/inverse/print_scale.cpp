#include "inverse/print_scale.h"

#include <algorithm>
#include <cmath>

#include "inverse/lateral_rest.h"

namespace morphgrid {
namespace {

// A few struts at a mesh's corners must not set the size of the whole sheet; inverse design finds
// other lengths for them.
constexpr double kOutliers = 0.01;

}  // namespace

double choosePrintScale(const StrutGrid& stacked, double maxShrinkage) {
  const LateralRest lateral(stacked.shape);
  Eigen::VectorXd shares = lateral.of(stacked).cwiseQuotient(lateral.lengthsAt(stacked.positions));
  std::sort(shares.begin(), shares.end());
  const auto last = static_cast<double>(shares.size() - 1);
  const double low = shares[std::lround(kOutliers * last)];
  const double high = shares[std::lround((1 - kOutliers) * last)];
  return std::sqrt(low * high / (1 - maxShrinkage));
}

}  // namespace morphgrid
