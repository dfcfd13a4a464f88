#include "grid/grid_topology.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <map>
#include <set>
#include <tuple>
#include <vector>

#include "tests/support/strut_list.h"

namespace morphgrid {
namespace {

class Topology : public testing::TestWithParam<GridShape> {
 protected:
  /// Steps between two vertices along u, v and w together.
  int distance(int a, int b) const {
    const GridPlace p = shape_.place(a);
    const GridPlace q = shape_.place(b);
    return std::abs(p.i - q.i) + std::abs(p.j - q.j) + std::abs(p.layer - q.layer);
  }

  GridShape shape_ = GetParam();
};

TEST_P(Topology, PlacesAndIndicesAreInverse) {
  int next = 0;
  forEachVertex(shape_, [&](const GridPlace& place) {
    EXPECT_EQ(shape_.index(place), next);
    EXPECT_EQ(shape_.place(next), place);
    EXPECT_EQ(shape_.index(shape_.column(next), place.layer), next);
    EXPECT_EQ(shape_.place(shape_.column(next)), (GridPlace{place.i, place.j, 0}));
    ++next;
  });
  EXPECT_EQ(next, shape_.vertexCount());
}

TEST_P(Topology, StrutsJoinAllNeighboursOnce) {
  std::set<std::pair<int, int>> joined;
  for (const Strut& strut : listStruts(shape_)) {
    EXPECT_TRUE(joined.insert({strut.from, strut.to}).second);
    EXPECT_EQ(strut.layer, shape_.place(strut.from).layer);
    EXPECT_EQ(strut.isLateral(), strut.layer == shape_.place(strut.to).layer);
  }
  std::set<std::pair<int, int>> neighbours;
  for (int a = 0; a < shape_.vertexCount(); ++a) {
    for (int b = a + 1; b < shape_.vertexCount(); ++b) {
      if (distance(a, b) == 1) {
        neighbours.insert({a, b});
      }
    }
  }
  EXPECT_EQ(joined, neighbours);
  EXPECT_EQ(shape_.strutCount(), static_cast<int>(neighbours.size()));
}

TEST_P(Topology, CountsTheStrutsOfEachDirection) {
  std::map<Strut::Direction, int> counts;
  for (const Strut& strut : listStruts(shape_)) {
    ++counts[strut.direction];
  }
  for (const auto direction : {Strut::Direction::u, Strut::Direction::v, Strut::Direction::w}) {
    EXPECT_EQ(shape_.strutCount(direction), counts[direction]);
  }
}

TEST_P(Topology, StrutsComeInTheOrderOfTheirVertices) {
  const std::vector<Strut> struts = listStruts(shape_);
  for (std::size_t n = 1; n < struts.size(); ++n) {
    EXPECT_LT(std::tuple(struts[n - 1].from, struts[n - 1].direction),
              std::tuple(struts[n].from, struts[n].direction));
  }
}

TEST_P(Topology, LateralStrutsAreTheStrutsWithinLayers) {
  std::vector<std::pair<int, int>> expected;
  for (const Strut& strut : listStruts(shape_)) {
    if (strut.direction != Strut::Direction::w) {
      expected.emplace_back(strut.from, strut.to);
    }
  }
  std::vector<std::pair<int, int>> visited;
  forEachLateralStrut(shape_,
                      [&](const Strut& strut) { visited.emplace_back(strut.from, strut.to); });
  EXPECT_EQ(visited, expected);
  EXPECT_EQ(shape_.lateralStrutCount(), static_cast<int>(expected.size()));
}

TEST_P(Topology, CornersAreAllPairsOfPerpendicularNeighboursOnce) {
  std::set<std::tuple<int, int, int>> visited;
  forEachCorner(shape_, [&](const Corner& corner) {
    EXPECT_TRUE(
        visited.insert({corner.apex, std::min(corner.a, corner.b), std::max(corner.a, corner.b)})
            .second);
  });
  std::set<std::tuple<int, int, int>> expected;
  for (int apex = 0; apex < shape_.vertexCount(); ++apex) {
    for (int a = 0; a < shape_.vertexCount(); ++a) {
      for (int b = a + 1; b < shape_.vertexCount(); ++b) {
        const GridPlace p = shape_.place(a);
        const GridPlace q = shape_.place(b);
        const bool isStraight = (p.i == q.i) + (p.j == q.j) + (p.layer == q.layer) == 2;
        if (distance(apex, a) == 1 && distance(apex, b) == 1 && !isStraight) {
          expected.insert({apex, a, b});
        }
      }
    }
  }
  EXPECT_EQ(visited, expected);
}

TEST_P(Topology, CellsLieBetweenFourVerticesOfALayer) {
  int count = 0;
  forEachCell(shape_, [&](const Cell& cell) {
    const auto [i, j, k] = cell.place;
    EXPECT_EQ(cell.vertex(0, 0), shape_.index(i, j, k));
    EXPECT_EQ(cell.vertex(1, 0), shape_.index(i + 1, j, k));
    EXPECT_EQ(cell.vertex(0, 1), shape_.index(i, j + 1, k));
    EXPECT_EQ(cell.vertex(1, 1), shape_.index(i + 1, j + 1, k));
    ++count;
  });
  EXPECT_EQ(count, shape_.layers * shape_.layerCellCount());
}

INSTANTIATE_TEST_SUITE_P(Shapes, Topology,
                         testing::Values(GridShape{2, 2, 1}, GridShape{5, 3, 2},
                                         GridShape{3, 4, 4}));

}  // namespace
}  // namespace morphgrid
