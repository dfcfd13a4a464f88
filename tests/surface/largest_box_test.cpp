#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include "surface/ray_hits.h"
#include "tests/surface/sample_hits.h"
#include "tests/surface/sample_meshes.h"

namespace morphgrid {
namespace {

constexpr double kAnySlope = std::numeric_limits<double>::infinity();

/// Rays (0, 0) to (countU - 1, countV - 1), a unit apart, all at x = 0.
RayHits flatHits(int countU, int countV) {
  return sampleHits({0, 0, countU - 1.0, countV - 1.0}, countU, countV,
                    [](double, double) { return 0; });
}

void expectBox(const std::optional<SamplingBox>& box, const SamplingBox& expected) {
  ASSERT_TRUE(box);
  EXPECT_NEAR(box->uStart, expected.uStart, 1e-12);
  EXPECT_NEAR(box->vStart, expected.vStart, 1e-12);
  EXPECT_NEAR(box->uLength, expected.uLength, 1e-12);
  EXPECT_NEAR(box->vLength, expected.vLength, 1e-12);
}

TEST(LargestBoxWithoutHoles, TakesTheWholeLattice) {
  expectBox(largestBoxWithoutHoles(flatHits(9, 6), kAnySlope), {0, 0, 8, 5});
  expectBox(largestBoxWithoutHoles(flatHits(4, 4), kAnySlope), {0, 0, 3, 3});
}

TEST(LargestBoxWithoutHoles, TakesTheLargerArmOfAnL) {
  RayHits hits = flatHits(20, 20);
  punchHole(hits, 8, 19, 6, 19);
  expectBox(largestBoxWithoutHoles(hits, kAnySlope), {0, 0, 7, 19});
}

TEST(LargestBoxWithoutHoles, TakesTheLargestSideOfAHole) {
  RayHits hits = flatHits(21, 21);
  punchHole(hits, 7, 10, 9, 12);
  expectBox(largestBoxWithoutHoles(hits, kAnySlope), {11, 0, 9, 20});
}

TEST(LargestBoxWithoutHoles, NeedsFourRaysEitherWay) {
  EXPECT_FALSE(largestBoxWithoutHoles(flatHits(3, 50), kAnySlope));
  EXPECT_FALSE(largestBoxWithoutHoles(flatHits(50, 3), kAnySlope));
  EXPECT_FALSE(largestBoxWithoutHoles(flatHits(2, 2), kAnySlope));
  RayHits hits = flatHits(40, 10);
  punchHole(hits, 0, 39, 3, 3);  // Leaves 40 x 3 and 40 x 6,
  punchHole(hits, 4, 39, 7, 7);  // and of these 40 x 3 and 4 x 6.
  expectBox(largestBoxWithoutHoles(hits, kAnySlope), {0, 4, 3, 5});
}

TEST(LargestBoxWithoutHoles, StopsAtSteepSteps) {
  const RayHits hits =
      sampleHits({0, 0, 20, 10}, 21, 11, [](double u, double) { return u < 12.5 ? 0.0 : 3.0; });
  expectBox(largestBoxWithoutHoles(hits, 3.1), {0, 0, 20, 10});
  expectBox(largestBoxWithoutHoles(hits, 2.9), {0, 0, 12, 10});
}

TEST(LargestBoxWithoutHoles, FindsNothingWhereAllMiss) {
  RayHits hits = flatHits(10, 10);
  punchHole(hits, 0, 9, 0, 9);
  EXPECT_FALSE(largestBoxWithoutHoles(hits, kAnySlope));
}

/// Finds it by trying all boxes.
int largestAreaOfAll(const RayHits& hits) {
  int largest = 0;
  for (int firstV = 0; firstV < hits.countV; ++firstV) {
    for (int firstU = 0; firstU < hits.countU; ++firstU) {
      for (int lastV = firstV + 3; lastV < hits.countV; ++lastV) {
        for (int lastU = firstU + 3; lastU < hits.countU; ++lastU) {
          bool whole = true;
          for (int j = firstV; j <= lastV; ++j) {
            for (int i = firstU; i <= lastU; ++i) {
              whole = whole && hits.hit[hits.index(i, j)];
            }
          }
          largest = whole ? std::max(largest, (lastU - firstU) * (lastV - firstV)) : largest;
        }
      }
    }
  }
  return largest;
}

TEST(LargestBoxWithoutHoles, AgreesWithASearchOfAllBoxes) {
  std::mt19937 random(3);
  for (int trial = 0; trial < 200; ++trial) {
    RayHits hits = flatHits(14, 11);
    for (int hole = 0; hole < 1 + trial % 12; ++hole) {
      const int i = int(random() % 14);
      const int j = int(random() % 11);
      punchHole(hits, i, i, j, j);
    }
    const auto box = largestBoxWithoutHoles(hits, kAnySlope);
    EXPECT_NEAR(box ? box->uLength * box->vLength : 0, largestAreaOfAll(hits), 1e-9) << trial;
  }
}

// --- Boxes of meshes.

/// A flat ring around the x axis.
TriangleMesh annulus(double inner, double outer) {
  TriangleMesh mesh = heightField({0, inner, 2 * std::numbers::pi, outer - inner}, 720, 4,
                                  [](double, double) { return 0; });
  for (auto vertex : mesh.vertices.colwise()) {
    const double angle = vertex.y();
    vertex = vertex.z() * Eigen::Vector3d(0, std::cos(angle), std::sin(angle));
  }
  return mesh;
}

/// The suggestion, once it is sure that its rays hit, as they do with other counts.
std::optional<SamplingBox> verifiedSuggestion(const TriangleMesh& mesh, double slopeLimit) {
  const MeshRayCaster caster(mesh);
  const auto box = suggestBox(caster, boundingBox(mesh), 100, 80, slopeLimit);
  if (box) {
    for (const auto& [countU, countV] : {std::pair{100, 80}, {41, 31}, {301, 303}}) {
      const RayHits hits = caster.cast(*box, countU, countV);
      EXPECT_TRUE(findHoles(hits).empty()) << countU;
      EXPECT_EQ(findJump(hits, 1.1 * slopeLimit).count, 0) << countU;
    }
  }
  return box;
}

TEST(SuggestBox, TakesAlmostAllOfASheet) {
  const TriangleMesh sheet =
      heightField({-3, 2, 6, 4}, 5, 5, [](double y, double z) { return 0.1 * y * z; });
  const auto box = verifiedSuggestion(sheet, 5);
  ASSERT_TRUE(box);
  const double margin = 0.004;  // Share of the extent: room for rounding what is printed.
  EXPECT_GE(box->uStart, -3 + margin * 6);
  EXPECT_LE(box->uStart + box->uLength, 3 - margin * 6);
  EXPECT_GE(box->vStart, 2 + margin * 4);
  EXPECT_LE(box->vStart + box->vLength, 6 - margin * 4);
  EXPECT_GE(box->uLength * box->vLength, 0.97 * 24);
}

TEST(SuggestBox, FitsBesideTheHoleOfAnAnnulus) {
  const auto box = verifiedSuggestion(annulus(0.5, 1), kAnySlope);
  ASSERT_TRUE(box);
  // From 0.5 to cos t, 2 sin t wide: largest where 4 cos^2 t - cos t - 2 = 0.
  const double cosine = (1 + std::sqrt(33.0)) / 8;
  const double area = 2 * (cosine - 0.5) * std::sqrt(1 - cosine * cosine);
  EXPECT_GE(box->uLength * box->vLength, 0.9 * area);
  EXPECT_LE(box->uLength * box->vLength, area);
}

TEST(SuggestBox, TakesTheLargerArmOfAnL) {
  const auto flat = [](double, double) { return 1; };
  const auto box = verifiedSuggestion(
      joined(heightField({0, 0, 2, 6}, 3, 3, flat), heightField({2, 0, 5, 1.5}, 3, 3, flat)), 1);
  ASSERT_TRUE(box);
  EXPECT_LE(box->uStart + box->uLength, 2);
  EXPECT_GE(box->uLength * box->vLength, 0.94 * 12);
}

TEST(SuggestBox, KeepsAwayFromTheSteepRimOfASphere) {
  const auto box = verifiedSuggestion(sphere(1, 200, 100), 1);
  ASSERT_TRUE(box);
  // |dx/dy| <= 1 and |dx/dz| <= 1 up to the corner: 2 c^2 + c^2 = 1.
  EXPECT_NEAR(box->uLength, 2 / std::sqrt(3.0), 0.04);
  EXPECT_NEAR(box->vLength, 2 / std::sqrt(3.0), 0.04);
}

TEST(SuggestBox, AvoidsASlitThatOnlyTheUsersRaysFind) {
  const auto flat = [](double, double) { return 0; };
  const double slit = 1e-4;  // Between rays 49 and 50 of the search's 200.
  const TriangleMesh mesh = joined(heightField({0, 0, 0.25 - slit, 1}, 2, 2, flat),
                                   heightField({0.25 + slit, 0, 0.75 - slit, 1}, 2, 2, flat));
  const MeshRayCaster caster(mesh);
  const auto wide = suggestBox(caster, boundingBox(mesh), 50, 50, 1);
  ASSERT_TRUE(wide);
  ASSERT_LT(wide->uStart, 0.25);
  const int count = 789;  // From 1/199 to 198/199, ray 195 runs through 0.25.
  ASSERT_EQ(findHoles(caster.cast(*wide, count, 50)).size(), 1U);
  const auto box = suggestBox(caster, boundingBox(mesh), count, 50, 1);
  ASSERT_TRUE(box);
  EXPECT_GT(box->uStart, 0.25);
  EXPECT_GT(box->uLength, 0.73);
  EXPECT_TRUE(findHoles(caster.cast(*box, count, 50)).empty());
}

TEST(SuggestBox, FindsNothingOnAMeshOfDust) {
  TriangleMesh dust = pyramidFan(3, 0);
  dust.vertices *= 0.001;
  TriangleMesh mesh = dust;
  for (int n = 1; n < 100; ++n) {
    const Eigen::Translation3d place(0, 0.1 * (n % 10), 0.1 * double(n / 10));
    mesh = joined(mesh, transformed(Eigen::Affine3d(place), dust));
  }
  EXPECT_FALSE(suggestBox(MeshRayCaster(mesh), boundingBox(mesh), 10, 10, 1));
}

TEST(SuggestBox, FindsNothingOnAMeshSeenEdgeOn) {
  const TriangleMesh sheet = heightField({0, 0, 1, 1}, 2, 2, [](double y, double) { return y; });
  for (const int flatAxis : {1, 2}) {
    TriangleMesh flat = sheet;
    flat.vertices.row(flatAxis).setZero();
    EXPECT_FALSE(suggestBox(MeshRayCaster(flat), boundingBox(flat), 10, 10, 1)) << flatAxis;
  }
}

}  // namespace
}  // namespace morphgrid
