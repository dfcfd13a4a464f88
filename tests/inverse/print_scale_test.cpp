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

/// Struts that lose up to this share, whatever their length.
BoundsAtScale uniform(double most) {
  return [=](double) { return ShrinkBounds{{0, most}}; };
}

TEST(PrintScale, SharesThatFitTheMaterialNeedNone) {
  EXPECT_NEAR(choosePrintScale(gridWithShares({0.6, 0.8, 1}), uniform(0.4)), 1, 1e-12);
}

TEST(PrintScale, StrutsThatWouldGrowGetALargerSheet) {
  const StrutGrid grid = gridWithShares({0.8, 1.25});
  const double scale = choosePrintScale(grid, uniform(0.5));
  EXPECT_NEAR(scale, std::sqrt(2), 1e-12);
  EXPECT_LT(1.25 / scale, 1);
  EXPECT_GT(0.8 / scale, 0.5);
}

TEST(PrintScale, HubsAskForALargerSheet) {
  // Of equal struts it is where each has as much room, as a ratio, to either side: by hand.
  StrutGrid grid = gridWithShares({0.8});
  const LateralRest lateral(grid.shape);
  const double length = lateral.lengthsAt(grid.positions).minCoeff();
  const ShrinkBounds bounds{{-0.08, 0.42}, 0.05, 0.4 * length};
  grid.rest = lateral.replacedIn(grid, Eigen::VectorXd::Constant(lateral.size(), 0.8 * length));
  StrutGrid even = grid;
  forEachVertex(grid.shape, [&](const GridPlace& place) {
    even.positions.col(grid.shape.index(place)) << length * place.i, length * place.j, place.layer;
  });
  const double scale = choosePrintScale(even, [&](double) { return bounds; });
  const ShrinkRange range = bounds.at(scale * length);
  EXPECT_NEAR(std::pow(0.8 / scale, 2), (1 - range.least) * (1 - range.most), 1e-9);
  EXPECT_LT(range.most, 0.42 - 0.1);
}

TEST(PrintScale, AFewStrutsDoNotSetTheSizeOfTheSheet) {
  StrutGrid grid = gridWithShares({0.6, 1});
  grid.rest.u[0] *= 5;
  EXPECT_NEAR(choosePrintScale(grid, uniform(0.4)), 1, 1e-12);
}

}  // namespace
}  // namespace morphgrid
