#include "render/spread_layers.h"

#include <gtest/gtest.h>

#include "tests/render/sample_grids.h"

namespace morphgrid {
namespace {

/// Where the first vertex of a layer went.
Eigen::Vector3d placeOf(const StrutGrid& spread, int layer) {
  return spread.positions.col(spread.shape.index(0, 0, layer));
}

TEST(SpreadLayers, SquaresFillASquarePicture) {
  const StrutGrid spread = spreadLayers(flatGrid({11, 11, 4}), 1);
  EXPECT_TRUE(placeOf(spread, 0).isZero());
  EXPECT_TRUE(placeOf(spread, 1).isApprox(Eigen::Vector3d(11, 0, 0)));
  EXPECT_TRUE(placeOf(spread, 2).isApprox(Eigen::Vector3d(0, -11, 0)));
  EXPECT_TRUE(placeOf(spread, 3).isApprox(Eigen::Vector3d(11, -11, 0)));
}

TEST(SpreadLayers, StripsLieAboveEachOther) {
  const StrutGrid spread = spreadLayers(flatGrid({31, 4, 3}), 4.0 / 3);
  EXPECT_TRUE(placeOf(spread, 1).isApprox(Eigen::Vector3d(0, -6, 0)));
  EXPECT_TRUE(placeOf(spread, 2).isApprox(Eigen::Vector3d(0, -12, 0)));
}

TEST(SpreadLayers, StripsAlongVLieBesideEachOther) {
  const StrutGrid spread = spreadLayers(flatGrid({4, 31, 3}), 4.0 / 3);
  EXPECT_TRUE(placeOf(spread, 2).isApprox(Eigen::Vector3d(12, 0, 0)));
}

TEST(SpreadLayers, LayersKeepTheirShape) {
  const StrutGrid grid = saddleGrid({6, 5, 7});
  const StrutGrid spread = spreadLayers(grid, 2);
  EXPECT_NO_THROW(validate(spread));
  forEachStrut(grid.shape, [&](const Strut& strut) {
    if (strut.direction != Strut::Direction::w) {
      const auto arm = [&](const StrutGrid& g) -> Eigen::Vector3d {
        return g.positions.col(strut.to) - g.positions.col(strut.from);
      };
      EXPECT_TRUE(arm(spread).isApprox(arm(grid), 1e-9));
    }
  });
}

}  // namespace
}  // namespace morphgrid
