#include "shared/topology.h"

#include <gtest/gtest.h>

#include <functional>
#include <vector>

#include "grid/strut_grid.h"

namespace morphgrid {
namespace {

class TopologyTest : public testing::TestWithParam<GridShape> {
 protected:
  int u() const { return shape_.verticesU; }
  int v() const { return shape_.verticesV; }
  int layers() const { return shape_.layers; }

  /// Visits the grid's vertices, and places up to two steps outside.
  void forEachPlace(const std::function<void(ivec3)>& visit) const {
    for (int k = -2; k < layers() + 2; ++k) {
      for (int j = -2; j < v() + 2; ++j) {
        for (int i = -2; i < u() + 2; ++i) {
          visit({i, j, k});
        }
      }
    }
  }

  const GridShape shape_ = GetParam();
  const ivec3 size_{shape_.verticesU, shape_.verticesV, shape_.layers};
};

TEST_P(TopologyTest, VerticesAreNumberedWithoutGaps) {
  std::vector<int> visits(shape_.vertexCount());
  forEachPlace([&](ivec3 place) {
    if (hasVertex(size_, place)) {
      EXPECT_EQ(vertexIndex(size_, place), shape_.index(place.x, place.y, place.z));
      ++visits.at(vertexIndex(size_, place));
    }
  });
  EXPECT_EQ(visits, std::vector<int>(visits.size(), 1));
}

TEST_P(TopologyTest, StrutsJoinNeighbours) {
  int count = 0;
  forEachPlace([&](ivec3 place) {
    for (int axis = 0; axis < 3; ++axis) {
      const bool expected = hasVertex(size_, place) &&
                            hasVertex(size_, place + ivec3(axis == 0, axis == 1, axis == 2));
      EXPECT_EQ(hasStrut(size_, place, axis), expected);
      count += expected ? 1 : 0;
    }
  });
  EXPECT_EQ(count, shape_.strutCount());
}

// Four to a face: a cell in a layer, or a lateral strut and the one above it.
TEST_P(TopologyTest, CornersAreThoseOfFaces) {
  int count = 0;
  forEachPlace([&](ivec3 apex) {
    for (const auto& [axisA, axisB] : {std::pair{0, 1}, {1, 2}, {0, 2}}) {
      for (const int stepA : {-1, 1}) {
        for (const int stepB : {-1, 1}) {
          const ivec3 a = neighbour(apex, axisA, stepA);
          const ivec3 b = neighbour(apex, axisB, stepB);
          EXPECT_EQ(hasCorner(size_, a, b), hasCorner(size_, b, a));
          count += hasCorner(size_, a, b) ? 1 : 0;
        }
      }
    }
  });
  const int cells = (u() - 1) * (v() - 1);
  const int lateralStruts = (u() - 1) * v() + u() * (v() - 1);
  EXPECT_EQ(count, 4 * (cells * layers() + lateralStruts * (layers() - 1)));
}

TEST_P(TopologyTest, BorderGoesRoundTheGrid) {
  int count = 0;
  for (int j = 0; j < v(); ++j) {
    for (int i = 0; i < u(); ++i) {
      count += isOnBorder(size_, {i, j}) ? 1 : 0;
    }
  }
  EXPECT_EQ(count, 2 * (u() + v()) - 4);
}

TEST_P(TopologyTest, ThinnedLatticeEndsAtTheLastPoint) {
  const ivec2 lattice(size_);
  for (int stride = 1; stride <= u() + v(); ++stride) {
    const ivec2 thinned = thinnedSize(lattice, stride);
    EXPECT_EQ(thinnedPoint(lattice, stride, ivec2(0)), ivec2(0));
    EXPECT_EQ(thinnedPoint(lattice, stride, thinned - 1), lattice - 1);
    const ivec2 beforeLast = thinnedPoint(lattice, stride, thinned - 2);
    EXPECT_TRUE(all(lessThan(beforeLast, lattice - 1)));
    EXPECT_TRUE(all(lessThanEqual(lattice - 1 - beforeLast, ivec2(stride))));
  }
}

INSTANTIATE_TEST_SUITE_P(OddShapes, TopologyTest,
                         testing::Values(GridShape{2, 2, 1}, GridShape{2, 5, 2}, GridShape{7, 3, 1},
                                         GridShape{4, 6, 3}));

}  // namespace
}  // namespace morphgrid
