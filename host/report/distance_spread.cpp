#include "report/distance_spread.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.h"

namespace morphgrid {
namespace {

double percentile(const std::vector<double>& sorted, double percent) {
  const double rank = std::ceil(percent / 100 * static_cast<double>(sorted.size()));
  return sorted[static_cast<std::size_t>(rank) - 1];
}

}  // namespace

DistanceSpread spreadOf(const Eigen::VectorXd& percents) {
  if (!percents.allFinite()) {
    throw InputError(
        "distances to the target are no finite numbers: lengths of the scene are too large, too "
        "small or too different");
  }
  std::vector<double> sorted(percents.begin(), percents.end());
  std::sort(sorted.begin(), sorted.end());
  DistanceSpread spread{percentile(sorted, 50), percentile(sorted, 90), percentile(sorted, 99)};
  const int bins = static_cast<int>(spread.counts.size());
  spread.binPercent = sorted.back() / bins;
  for (const double value : sorted) {
    const int bin = spread.binPercent > 0 ? static_cast<int>(value / spread.binPercent) : 0;
    ++spread.counts[std::min(bin, bins - 1)];
  }
  return spread;
}

}  // namespace morphgrid
