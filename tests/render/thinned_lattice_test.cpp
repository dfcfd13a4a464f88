#include "render/thinned_lattice.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "grid/strain.h"
#include "tests/render/sample_grids.h"

namespace morphgrid {
namespace {

TEST(ThinnedLattice, KeepsEveryNthColumnAndTheLast) {
  const StrutGrid grid = saddleGrid({12, 5, 2});
  const ThinnedLattice lattice(grid.shape, 4);  // Every third.
  const Eigen::Matrix3Xd points = lattice.points(grid.positions);
  const int columns[] = {0, 3, 6, 9, 11}, rows[] = {0, 3, 4};
  ASSERT_EQ(points.cols(), 5 * 3 * 2);
  for (int n = 0; n < points.cols(); ++n) {
    const int whole = grid.shape.index(columns[n % 5], rows[n / 5 % 3], n / 15);
    EXPECT_EQ(points.col(n), grid.positions.col(whole)) << n;
  }
}

TEST(ThinnedLattice, IsWholeWhereCellsAreFew) {
  EXPECT_TRUE(ThinnedLattice({12, 5, 2}, 11).isWhole());
  EXPECT_FALSE(ThinnedLattice({12, 5, 2}, 10).isWhole());
  EXPECT_FALSE(ThinnedLattice({5, 12, 2}, 10).isWhole());
}

TEST(ThinnedLattice, StrutsAreStrainedAsTheFirstThatTheyStandFor) {
  const StrutGrid grid = saddleGrid({12, 9, 3});
  const ThinnedLattice lattice(grid.shape, 6);
  const StrutGrid drawn = lattice.grid(grid, grid.positions);
  validate(drawn);
  EXPECT_EQ(drawn.spacing, 2 * grid.spacing);
  forEachStrut(drawn.shape, [&](const Strut& strut) {
    const GridPlace place = drawn.shape.place(strut.from);
    const int from = grid.shape.index(std::min(2 * place.i, grid.shape.cellsU()),
                                      std::min(2 * place.j, grid.shape.cellsV()), place.layer);
    const int step = strut.direction == Strut::Direction::u   ? 1
                     : strut.direction == Strut::Direction::v ? grid.shape.verticesU
                                                              : grid.shape.layerVertexCount();
    const Strut first{from, from + step, strut.direction, place.layer};
    EXPECT_NEAR(strainAt(drawn, drawn.positions, strut), strainAt(grid, grid.positions, first),
                1e-12);
  });
}

}  // namespace
}  // namespace morphgrid
