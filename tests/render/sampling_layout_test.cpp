#include "render/sampling_layout.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/render/sample_samplings.h"

namespace morphgrid {
namespace {

const SamplingBox kBox{2, 3, 8, 6};

double flat(double, double) { return 10; }
double ramp(double y, double) { return y; }

Eigen::Vector2d placeInPicture(const Camera& camera, const Eigen::Vector3d& point) {
  const glm::dvec4 clip = camera.clipFromWorld() * glm::dvec4(point.x(), point.y(), point.z(), 1);
  EXPECT_GT(clip.z, 0) << "in front of the near plane";
  EXPECT_LT(clip.z, clip.w) << "behind the far plane";
  return Eigen::Vector2d(clip.x, clip.y) / clip.w;
}

SamplingLayout layoutOf(const RayHits& hits) {
  return layOutSampling(heightMesh(flat, 12, 12, 4, 4), hits);
}

TEST(DrawnIsolines, AreAllWhereTheyAreFew) {
  for (const int rays : {2, 3, 17, 41}) {
    const DrawnIsolines isolines(rays);
    EXPECT_EQ(isolines.count, rays);
    EXPECT_EQ(isolines.at(rays - 1), rays - 1);
  }
}

TEST(DrawnIsolines, OfManyAreEvenAndEndWithTheLast) {
  for (int rays = 42; rays < 1200; ++rays) {
    const DrawnIsolines isolines(rays);
    ASSERT_LE(isolines.count, DrawnIsolines::kMostCells + 1);
    ASSERT_GE(isolines.count, DrawnIsolines::kMostCells / 2);
    ASSERT_EQ(isolines.at(0), 0);
    ASSERT_EQ(isolines.at(isolines.count - 1), rays - 1);
    for (int n = 1; n < isolines.count; ++n) {
      const int step = isolines.at(n) - isolines.at(n - 1);
      ASSERT_GT(step, 0);
      ASSERT_TRUE(step == isolines.stride || (n == isolines.count - 1 && step < isolines.stride));
    }
  }
}

TEST(SamplingLayout, SpansTheBoxAndTheDepthOfTheHits) {
  RayHits hits = heightHits(ramp, kBox, 9, 7);
  miss(hits, 0, 0);  // Its x of 0 is no depth.
  const SamplingLayout layout = layoutOf(hits);
  EXPECT_TRUE(layout.sampled.min().isApprox(Eigen::Vector3d(2, 2, 3)));
  EXPECT_TRUE(layout.sampled.max().isApprox(Eigen::Vector3d(10, 10, 9)));
  EXPECT_EQ(layout.rayStep, 1);
  EXPECT_EQ(layout.cell, 1);
}

TEST(SamplingLayout, WithoutHitsHasTheMeshsDepth) {
  RayHits hits = heightHits(flat, kBox, 2, 2);
  hits.hit.assign(4, 0);
  hits.points.row(0).setZero();
  const SamplingLayout layout = layoutOf(hits);
  EXPECT_EQ(layout.sampled.center(), Eigen::Vector3d(10, 6, 6));
  EXPECT_EQ(crossingHits(layout, hits).cols(), 0);
  EXPECT_EQ(missedMarks(layout, hits).cols(), 4);
}

TEST(SamplingLayout, HitsAreShownWhereDrawnIsolinesCross) {
  RayHits hits = heightHits(ramp, kBox, 101, 61);  // Every third i and every second j.
  EXPECT_EQ(crossingHits(layoutOf(hits), hits).cols(), 35 * 31);
  miss(hits, 3, 2);
  miss(hits, 4, 2);
  const Eigen::Matrix3Xd shown = crossingHits(layoutOf(hits), hits);
  EXPECT_EQ(shown.cols(), 35 * 31 - 1);
  EXPECT_EQ(shown.col(1), hits.points.col(hits.index(3, 0)));
}

TEST(SamplingLayout, EveryMissedRayHasAMark) {
  RayHits hits = heightHits(flat, kBox, 101, 61);
  miss(hits, 50, 30);                  // Alone, on no drawn isoline.
  miss(hits, 0, 0), miss(hits, 2, 1);  // Share a mark.
  miss(hits, 100, 60);                 // The last.
  const Eigen::Matrix3Xd marks = missedMarks(layoutOf(hits), hits);
  ASSERT_EQ(marks.cols(), 3);
  EXPECT_TRUE(marks.col(0).isApprox(Eigen::Vector3d(10, 2.08, 3.05)));
  EXPECT_TRUE(marks.col(1).isApprox(Eigen::Vector3d(10, 6, 6)));
  EXPECT_TRUE(marks.col(2).isApprox(Eigen::Vector3d(10, 10, 9)));
}

TEST(FrameRays, BoxIsCenteredAndLargeSeenFromWhereTheRaysCome) {
  const RayHits hits = heightHits(flat, kBox, 9, 7);
  const Camera camera = frameRays(heightMesh(flat, 50, 50, 4, 4), hits, 1);
  EXPECT_LT(camera.eye().x, 10);
  EXPECT_LT(placeInPicture(camera, {10, 6, 6}).norm(), 1e-9);
  EXPECT_NEAR(placeInPicture(camera, {10, 10, 6}).y(), -0.9, 1e-9) << "y up; Vulkan's points down";
  EXPECT_NEAR(placeInPicture(camera, {10, 6, 9}).x(), 0.9 * 3 / 4, 1e-9) << "z to the right";
}

TEST(FrameRays, WholeDepthOfTheMeshIsInView) {
  const auto steep = [](double y, double) { return 300 - 30 * y; };
  const auto bump = [](double, double) { return 250.0; };
  const RayHits hits = heightHits(bump, kBox, 9, 7);
  const Camera camera = frameRays(heightMesh(steep, 12, 12, 4, 4), hits, 1.3);
  placeInPicture(camera, {300, 6, 6});
  placeInPicture(camera, {-60, 6, 6});
}

}  // namespace
}  // namespace morphgrid
