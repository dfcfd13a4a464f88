#include "surface/ray_hits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "tests/surface/sample_hits.h"
#include "tests/surface/sample_meshes.h"

namespace morphgrid {
namespace {

/// 21 x 11 rays, 0.1 and 0.2 apart.
constexpr SamplingBox kBox{1, -1, 2, 2};

double linear(double u, double v) { return 3 - 2 * u + 0.5 * v; }

RayHits linearHits() { return sampleHits(kBox, 21, 11, linear); }

double largestError(const RayHits& hits, double (*exact)(double, double)) {
  double largest = 0;
  for (const auto& point : hits.points.colwise()) {
    largest = std::max(largest, std::abs(point.x() - exact(point.y(), point.z())));
  }
  return largest;
}

TEST(FindHoles, FindsNoneWhereAllRaysHit) { EXPECT_TRUE(findHoles(linearHits()).empty()); }

TEST(FindHoles, CountsAndPlacesThemTheLargestFirst) {
  RayHits hits = linearHits();
  punchHole(hits, 20, 20, 10, 10);
  punchHole(hits, 3, 5, 2, 3);
  const auto holes = findHoles(hits);
  ASSERT_EQ(holes.size(), 2U);
  EXPECT_EQ(holes[0].rays, 6);
  EXPECT_NEAR(holes[0].uMin, 1.3, 1e-12);
  EXPECT_NEAR(holes[0].uMax, 1.5, 1e-12);
  EXPECT_NEAR(holes[0].vMin, -0.6, 1e-12);
  EXPECT_NEAR(holes[0].vMax, -0.4, 1e-12);
  EXPECT_EQ(holes[1].rays, 1);
  EXPECT_EQ(holes[1].uMin, 3);
  EXPECT_EQ(holes[1].vMax, 1);
}

TEST(FindHoles, JoinsRaysThatTouchDiagonally) {
  RayHits hits = linearHits();
  for (int n = 0; n < 11; ++n) {
    punchHole(hits, n, n, n, n);
    punchHole(hits, 20 - n, 20 - n, n, n);
  }
  const auto holes = findHoles(hits);  // Two diagonals that meet at (10, 10).
  ASSERT_EQ(holes.size(), 1U);
  EXPECT_EQ(holes[0].rays, 21);
  EXPECT_EQ(holes[0].uMin, 1);
  EXPECT_EQ(holes[0].uMax, 3);
}

TEST(FindHoles, DoesNotJoinTheEndOfARowToTheNextRow) {
  RayHits hits = linearHits();
  punchHole(hits, 20, 20, 4, 4);
  punchHole(hits, 0, 0, 5, 5);
  EXPECT_EQ(findHoles(hits).size(), 2U);
}

TEST(FindHoles, TakesEveryRayWhenAllMiss) {
  RayHits hits = linearHits();
  punchHole(hits, 0, 20, 0, 10);
  const auto holes = findHoles(hits);
  ASSERT_EQ(holes.size(), 1U);
  EXPECT_EQ(holes[0].rays, 231);
  EXPECT_EQ(holes[0].uMax, 3);
}

TEST(FindJump, MeasuresTheSlopeOfAPlane) {
  const Jump jump = findJump(linearHits(), 1);
  EXPECT_NEAR(jump.slope, 2, 1e-9);
  EXPECT_EQ(jump.count, 20 * 11);  // Those along u; along v it is 0.5.
  EXPECT_EQ(findJump(linearHits(), 2.001).count, 0);
}

TEST(FindJump, FindsTheEdgeOfAnOverhang) {
  // Two parallel sheets, the front one over v > 0.3 only.
  const TriangleMesh mesh =
      joined(heightField({-1, -1, 2, 2}, 2, 2, [](double, double) { return 5; }),
             heightField({-1, 0.3, 2, 0.7}, 2, 2, [](double, double) { return 2; }));
  const RayHits hits = MeshRayCaster(mesh).cast({-1, -1, 2, 2}, 11, 21);
  const Jump jump = findJump(hits, 4);
  EXPECT_EQ(jump.count, 11);
  EXPECT_NEAR(jump.slope, 3 / 0.1, 1e-9);
  EXPECT_NEAR(jump.v, 0.25, 1e-12);
}

TEST(FindJump, PlacesASpikeBetweenItsRays) {
  RayHits hits = linearHits();
  hits.points(0, hits.index(7, 4)) += 10;  // Steepest along u, towards smaller x: away from u = 2.
  const Jump jump = findJump(hits, 40);
  EXPECT_EQ(jump.count, 4);
  EXPECT_NEAR(jump.slope, 102, 1e-9);
  EXPECT_NEAR(jump.u, 1.75, 1e-12);
  EXPECT_NEAR(jump.v, -0.2, 1e-12);
}

TEST(FindJump, PassesOverRaysThatMiss) {
  RayHits hits = sampleHits(kBox, 21, 11, [](double, double) { return 100; });
  punchHole(hits, 4, 6, 0, 10);
  EXPECT_EQ(findJump(hits, 1).slope, 0);
  EXPECT_EQ(findJump(hits, 1).count, 0);
  punchHole(hits, 0, 20, 0, 10);
  EXPECT_EQ(findJump(hits, 0).slope, 0);
}

TEST(FillHoles, IsExactForALinearField) {
  RayHits hits = linearHits();
  punchHole(hits, 3, 5, 2, 3);
  punchHole(hits, 6, 6, 4, 4);    // Touches the first at a corner.
  punchHole(hits, 12, 19, 1, 9);  // All but the box's edge.
  punchHole(hits, 9, 9, 5, 5);
  const long holes = countMisses(hits);
  EXPECT_EQ(fillHoles(hits, 10), holes);
  EXPECT_EQ(countMisses(hits), 0);
  EXPECT_LE(largestError(hits, linear), 1e-12);
}

TEST(FillHoles, IsExactForAHarmonicFieldWhateverTheSteps) {
  const auto saddle = [](double u, double v) { return u * u - v * v; };
  RayHits hits = sampleHits(kBox, 21, 11, saddle);
  punchHole(hits, 4, 12, 3, 7);
  EXPECT_EQ(fillHoles(hits, 10), 45);
  EXPECT_LE(largestError(hits, saddle), 1e-12);
}

TEST(FillHoles, ComesCloseToASmoothField) {
  const auto dome = [](double u, double v) { return std::sqrt(9 - u * u - v * v); };
  RayHits hits = sampleHits({-1, -1, 2, 2}, 41, 41, dome);
  punchHole(hits, 10, 14, 20, 24);
  EXPECT_EQ(fillHoles(hits, 0.3), 25);
  const double filled = hits.points(0, hits.index(12, 22));
  // A membrane lies below the dome by |Laplacian| width^2 (0.0737): 0.67 0.3^2 0.0737 = 0.0045.
  EXPECT_NEAR(filled, dome(hits.u(12), hits.v(22)) - 0.0045, 0.001);
}

TEST(FillHoles, RespectsWidestInEitherDirection) {
  const auto filled = [](int raysU, int raysV, double widest) {
    RayHits hits = linearHits();
    punchHole(hits, 5, 4 + raysU, 3, 2 + raysV);
    return fillHoles(hits, widest);
  };
  EXPECT_EQ(filled(1, 1, 0.4), 1);  // 0.2 x 0.4, the rays beside it counted in.
  EXPECT_EQ(filled(1, 1, 0.39), 0);
  EXPECT_EQ(filled(3, 1, 0.4), 3);
  EXPECT_EQ(filled(4, 1, 0.4), 0);
  EXPECT_EQ(filled(4, 2, 0.6), 8);
  EXPECT_EQ(filled(4, 3, 0.6), 0);
  EXPECT_EQ(filled(1, 1, 0), 0);
  EXPECT_EQ(filled(2, 2, std::numeric_limits<double>::infinity()), 4);
}

TEST(FillHoles, LeavesHolesAtTheBoxsEdge) {
  RayHits hits = linearHits();
  punchHole(hits, 0, 1, 4, 4);
  punchHole(hits, 19, 20, 4, 4);
  punchHole(hits, 5, 5, 0, 1);
  punchHole(hits, 9, 9, 9, 10);
  punchHole(hits, 14, 14, 5, 5);
  EXPECT_EQ(fillHoles(hits, 1), 1);
  EXPECT_EQ(countMisses(hits), 8);
  EXPECT_EQ(hits.points(0, hits.index(0, 4)), 0);
}

TEST(FillHoles, LeavesRaysThatHitAsTheyAre) {
  RayHits hits = linearHits();
  punchHole(hits, 5, 7, 5, 7);
  const RayHits before = hits;
  fillHoles(hits, 1);
  for (Eigen::Index n = 0; n < hits.points.cols(); ++n) {
    if (before.hit[n]) {
      EXPECT_EQ(hits.points.col(n), before.points.col(n));
    }
  }
  EXPECT_EQ(fillHoles(hits, 1), 0);
}

}  // namespace
}  // namespace morphgrid
