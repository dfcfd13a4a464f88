#include "render/camera.h"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

namespace morphgrid {
namespace {

Eigen::Vector3d placeOf(const Camera& camera, const Eigen::Vector3d& point) {
  const glm::dvec4 clip = camera.clipFromWorld() * glm::dvec4(point.x(), point.y(), point.z(), 1);
  EXPECT_GT(clip.w, 0);
  return Eigen::Vector3d(clip.x, clip.y, clip.z) / clip.w;
}

/// Columns: the points' places in the picture, -1 .. 1 in x and y, 0 .. 1 in depth.
Eigen::Matrix3Xd ndcOf(const Camera& camera, const Eigen::Matrix3Xd& points) {
  Eigen::Matrix3Xd ndc(3, points.cols());
  for (Eigen::Index n = 0; n < points.cols(); ++n) {
    ndc.col(n) = placeOf(camera, Eigen::Vector3d(points.col(n)));
  }
  return ndc;
}

Eigen::Matrix3Xd boxCorners(const Eigen::Vector3d& size) {
  Eigen::Matrix3Xd corners(3, 8);
  for (int n = 0; n < 8; ++n) {
    corners.col(n) << (n & 1) * size.x(), (n >> 1 & 1) * size.y(), (n >> 2 & 1) * size.z();
  }
  return corners;
}

class FramedBoxes : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Aspects, FramedBoxes, testing::Values(0.3, 0.75, 1.0, 4.0 / 3, 3.7));

TEST_P(FramedBoxes, LieInsideWithAMargin) {
  std::srand(3);
  for (int n = 0; n < 100; ++n) {
    const Eigen::Vector3d size = Eigen::Array3d(1000, 30, 5) * Eigen::Array3d::Random().abs();
    const Eigen::Vector3d offset = 1e4 * Eigen::Vector3d::Random();
    const Eigen::Matrix3Xd points = boxCorners(size).colwise() + offset;
    const Camera camera = frameAll(points, Eigen::Vector3d::Random(), kUpwards, GetParam());
    const Eigen::Matrix3Xd ndc = ndcOf(camera, points);
    EXPECT_LT(ndc.topRows(2).cwiseAbs().maxCoeff(), 0.9 + 1e-6);
    EXPECT_GT(ndc.row(2).minCoeff(), 0);
    EXPECT_LT(ndc.row(2).maxCoeff(), 1);
    const Eigen::Vector3d center = ndc.rowwise().maxCoeff() + ndc.rowwise().minCoeff();
    EXPECT_LT(center.head(2).cwiseAbs().maxCoeff(), 1e-6);
  }
}

TEST_P(FramedBoxes, FillOneSideOfThePicture) {
  std::srand(4);
  for (int n = 0; n < 100; ++n) {
    const Eigen::Array3d share = 0.75 + 0.25 * Eigen::Array3d::Random();
    const Eigen::Matrix3Xd points = boxCorners(Eigen::Array3d(10, 8, 5) * share);
    const Camera camera = frameAll(points, Eigen::Vector3d::Random(), kUpwards, GetParam());
    EXPECT_NEAR(ndcOf(camera, points).topRows(2).cwiseAbs().maxCoeff(), 0.9, 1e-6);
  }
}

TEST(Camera, UpIsUpAndRightIsRight) {
  const Camera camera =
      frameAll(boxCorners({1, 1, 1}), Eigen::Vector3d(0, 1, 0), Eigen::Vector3d(0, 0, 1), 1);
  EXPECT_LT(placeOf(camera, Eigen::Vector3d(0.5, 0.5, 1)).y(), 0) << "Vulkan's y points down";
  EXPECT_GT(placeOf(camera, Eigen::Vector3d(1, 0.5, 0.5)).x(), 0);
  EXPECT_LT(placeOf(camera, Eigen::Vector3d(0.5, 0, 0.5)).z(),
            placeOf(camera, Eigen::Vector3d(0.5, 1, 0.5)).z())
      << "nearer is less deep";
}

TEST(Camera, EyeIsBehindThePointsAgainstTheView) {
  const Camera camera = frameAll(boxCorners({2, 2, 2}), {0, 1, 0}, kUpwards, 1);
  const glm::dvec3 eye = camera.eye();
  EXPECT_NEAR(eye.x, 1, 1e-9);
  EXPECT_LT(eye.y, 0);
  EXPECT_NEAR(eye.z, 1, 1e-9);
}

TEST(Camera, ViewAlongUpIsPossible) {
  const Eigen::Matrix3Xd points = boxCorners({3, 2, 0});
  const Eigen::Matrix3Xd ndc =
      ndcOf(frameAll(points, Eigen::Vector3d(0, 0, -1), kUpwards, 1.5), points);
  EXPECT_TRUE(ndc.allFinite());
  EXPECT_LT(ndc.topRows(2).cwiseAbs().maxCoeff(), 0.95);
}

TEST(Camera, DegeneratePointsAreFramed) {
  const Eigen::Vector3d view(0, 1, 0);
  Eigen::Matrix3Xd one(3, 1), line(3, 2);
  one << 5, 6, 7;
  line << 1, 1, 0, 9, 2, 2;  // Along the view.
  for (const Eigen::Matrix3Xd& points : {one, line}) {
    const Eigen::Matrix3Xd ndc = ndcOf(frameAll(points, view, kUpwards, 1.3), points);
    EXPECT_LT(ndc.topRows(2).cwiseAbs().maxCoeff(), 1e-6);
    EXPECT_GT(ndc.row(2).minCoeff(), 0);
    EXPECT_LT(ndc.row(2).maxCoeff(), 1);
  }
}

TEST(Camera, ScalesWithTheScene) {
  const Eigen::Matrix3Xd points = boxCorners({3, 2, 1});
  const Camera camera = frameAll(points, kObliqueViewDirection, kUpwards, 1.3);
  const Camera larger = frameAll(1000 * points, kObliqueViewDirection, kUpwards, 1.3);
  EXPECT_LT((ndcOf(camera, points) - ndcOf(larger, 1000 * points)).cwiseAbs().maxCoeff(), 1e-9);
}

}  // namespace
}  // namespace morphgrid
