#pragma once
#include <Eigen/Core>
#include <array>

namespace morphgrid {

/// How distances are spread: percentiles and a histogram from 0 to the largest, in percent of the
/// diagonal.
struct DistanceSpread {
  double medianPercent = 0;
  double percentile90 = 0;
  double percentile99 = 0;
  double binPercent = 0;         ///< Width of a bin.
  std::array<int, 10> counts{};  ///< The largest distance is in the last bin.
};

/// percents: at least one, >= 0; throws InputError where one is not finite. A percentile p is the
/// smallest value that p % of them do not exceed.
DistanceSpread spreadOf(const Eigen::VectorXd& percents);

}  // namespace morphgrid
