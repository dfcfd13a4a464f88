#include "report/distance_spread.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numeric>

#include "core/error.h"

namespace morphgrid {
namespace {

TEST(DistanceSpread, PercentilesAreValuesThatTheShareDoesNotExceed) {
  Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(200, 1, 200);
  std::reverse(values.begin(), values.end());
  const DistanceSpread spread = spreadOf(values);
  EXPECT_EQ(spread.medianPercent, 100);
  EXPECT_EQ(spread.percentile90, 180);
  EXPECT_EQ(spread.percentile99, 198);
}

TEST(DistanceSpread, HistogramRunsFromZeroToTheLargest) {
  const DistanceSpread spread = spreadOf(Eigen::VectorXd::LinSpaced(101, 0, 2));
  EXPECT_DOUBLE_EQ(spread.binPercent, 0.2);
  EXPECT_EQ(std::accumulate(spread.counts.begin(), spread.counts.end(), 0), 101);
  for (const int count : spread.counts) {
    EXPECT_NEAR(count, 10, 1);  // Rounding moves a value on the edge of a bin.
  }
}

TEST(DistanceSpread, RefusesWhatIsNoNumber) {
  for (const double bad : {std::nan(""), std::numeric_limits<double>::infinity()}) {
    Eigen::VectorXd values = Eigen::VectorXd::LinSpaced(5, 0, 1);
    values[2] = bad;
    EXPECT_THROW(spreadOf(values), InputError);
  }
}

TEST(DistanceSpread, OfNoDistanceOrOfOne) {
  EXPECT_EQ(spreadOf(Eigen::VectorXd::Zero(4)).counts[0], 4);
  const DistanceSpread one = spreadOf(Eigen::VectorXd::Constant(1, 3));
  EXPECT_EQ(one.counts[9], 1);
  EXPECT_EQ(one.medianPercent, 3);
  EXPECT_EQ(one.percentile99, 3);
}

}  // namespace
}  // namespace morphgrid
