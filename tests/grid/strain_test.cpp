#include "grid/strain.h"

#include <gtest/gtest.h>

#include "tests/support/strut_list.h"

namespace morphgrid {
namespace {

/// A box lattice of steps 1, 2, 3 along u, v, w, whose struts rest at those lengths.
StrutGrid boxGrid(const GridShape& shape) {
  StrutGrid grid{.shape = shape, .spacing = 1, .rest = StrutValues(shape), .weights = {1}};
  grid.positions.resize(3, shape.vertexCount());
  for (int k = 0; k < shape.layers; ++k) {
    for (int j = 0; j < shape.verticesV; ++j) {
      for (int i = 0; i < shape.verticesU; ++i) {
        grid.positions.col(shape.index(i, j, k)) << i, 2 * j, 3 * k;
      }
    }
  }
  forEachStrut(shape, [&](const Strut& strut) {
    valueAt(grid.rest, strut) = 1.0 + static_cast<int>(strut.direction);
  });
  return grid;
}

TEST(Strains, AreZeroAtRestAndUnderRigidMotion) {
  const StrutGrid grid = boxGrid({5, 3, 2});
  Eigen::Matrix3d rotation;
  rotation << 0, 0, 1, 1, 0, 0, 0, 1, 0;
  const Eigen::Matrix3Xd moved = (rotation * grid.positions).colwise() + Eigen::Vector3d(7, -8, 9);
  for (const Eigen::Matrix3Xd& positions : {grid.positions, moved}) {
    const std::vector<double> result = strains(grid, positions);
    EXPECT_EQ(result, std::vector<double>(grid.shape.strutCount(), 0.0));
  }
}

TEST(Strains, StretchingTheAxesStrainsTheirStruts) {
  const StrutGrid grid = boxGrid({4, 3, 3});
  const Eigen::Vector3d stretch(1.25, 0.5, 3);
  const std::vector<double> result = strains(grid, stretch.asDiagonal() * grid.positions);
  const std::vector<Strut> struts = listStruts(grid.shape);
  ASSERT_EQ(result.size(), struts.size());
  for (std::size_t i = 0; i < struts.size(); ++i) {
    EXPECT_DOUBLE_EQ(result[i], stretch[static_cast<int>(struts[i].direction)] - 1);
  }
}

TEST(Strains, FollowTheOrderOfTheStruts) {
  StrutGrid grid = boxGrid({3, 2, 2});
  const std::vector<Strut> struts = listStruts(grid.shape);
  for (std::size_t i = 0; i < struts.size(); ++i) {
    valueAt(grid.rest, struts[i]) /= 1.0 + i;
  }
  const std::vector<double> result = strains(grid, grid.positions);
  for (std::size_t i = 0; i < struts.size(); ++i) {
    EXPECT_NEAR(result[i], i, 1e-13);
  }
}

}  // namespace
}  // namespace morphgrid
