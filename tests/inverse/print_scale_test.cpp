#include "inverse/print_scale.h"

#include <gtest/gtest.h>

#include <cmath>

#include "inverse/lateral_rest.h"
#include "tests/solve/sample_grids.h"

namespace morphgrid {
namespace {

/// Rest lengths at the given shares of the printed lengths, in turn.
StrutGrid gridWithShares(const std::vector<double>& shares) {
  StrutGrid grid = bentGrid({21, 16, 3}, 5);
  const LateralRest lateral(grid.shape);
  Eigen::VectorXd rest = lateral.lengthsAt(grid.positions);
  for (Eigen::Index n = 0; n < rest.size(); ++n) {
    rest[n] *= shares[static_cast<std::size_t>(n) % shares.size()];
  }
  grid.rest = lateral.replacedIn(grid, rest);
  return grid;
}

TEST(PrintScale, SharesThatFitTheMaterialNeedNone) {
  EXPECT_NEAR(choosePrintScale(gridWithShares({0.6, 0.8, 1}), 0.4), 1, 1e-12);
}

TEST(PrintScale, StrutsThatWouldGrowGetALargerSheet) {
  const StrutGrid grid = gridWithShares({0.8, 1.25});
  const double scale = choosePrintScale(grid, 0.5);
  EXPECT_NEAR(scale, std::sqrt(2), 1e-12);
  EXPECT_LT(1.25 / scale, 1);
  EXPECT_GT(0.8 / scale, 0.5);
}

TEST(PrintScale, AFewStrutsDoNotSetTheSizeOfTheSheet) {
  StrutGrid grid = gridWithShares({0.6, 1});
  grid.rest.u[0] *= 5;
  EXPECT_NEAR(choosePrintScale(grid, 0.4), 1, 1e-12);
}

}  // namespace
}  // namespace morphgrid
