#include "view/orbit_camera.h"

#include <gtest/gtest.h>

#include <numbers>

namespace morphgrid {
namespace {

const Eigen::Vector3d kUp(0, 0, 1);
const Eigen::AlignedBox3d kBox(Eigen::Vector3d(-1, -2, 0), Eigen::Vector3d(3, 2, 1));
constexpr double kAspect = 1.5;

OrbitCamera framed() {
  OrbitCamera camera(kUp);
  camera.frame(kBox, kPatchView, kAspect);
  return camera;
}

/// Where a point lies in the picture: x and y from -1 to 1, depth from 0 to 1.
Eigen::Vector3d project(const OrbitCamera& camera, const Eigen::Vector3d& point) {
  const glm::dvec4 clip =
      camera.camera(kBox, kAspect).clipFromWorld() * glm::dvec4(point.x(), point.y(), point.z(), 1);
  return Eigen::Vector3d(clip.x, clip.y, clip.z) / clip.w;
}

TEST(OrbitCamera, FramesAllCornersBetweenItsPlanes) {
  const OrbitCamera camera = framed();
  for (int n = 0; n < 8; ++n) {
    const Eigen::Vector3d at =
        project(camera, kBox.corner(static_cast<Eigen::AlignedBox3d::CornerType>(n)));
    EXPECT_LT(at.head<2>().cwiseAbs().maxCoeff(), 1);
    EXPECT_GT(at.z(), 0);
    EXPECT_LT(at.z(), 1);
  }
}

TEST(OrbitCamera, TurningKeepsThePivotAndTheDistance) {
  OrbitCamera camera = framed();
  const Eigen::Vector3d before = project(camera, camera.pivot());
  camera.turn(0.7, -0.2);
  EXPECT_LT((project(camera, camera.pivot()) - before).head<2>().norm(), 1e-9);
  EXPECT_NEAR(
      (camera.rotation() * camera.rotation().transpose() - Eigen::Matrix3d::Identity()).norm(), 0,
      1e-12);
}

TEST(OrbitCamera, TurningToTheRightMovesWhatIsInFrontToTheRight) {
  OrbitCamera camera = framed();
  const Eigen::Vector3d inFront = camera.pivot() + 0.1 * camera.rotation().row(2).transpose();
  const double before = project(camera, inFront).x();
  camera.turn(0.05, 0);
  EXPECT_GT(project(camera, inFront).x(), before);
}

TEST(OrbitCamera, NeverTurnsOverThePole) {
  OrbitCamera camera = framed();
  for (int n = 0; n < 100; ++n) {
    camera.turn(0, 0.2);
  }
  EXPECT_NEAR(camera.rotation().row(2).dot(kUp), 1, 1e-9);
  EXPECT_GT(camera.rotation().row(1).norm(), 0.99);
  for (int n = 0; n < 100; ++n) {
    camera.turn(0, -0.2);
  }
  EXPECT_NEAR(camera.rotation().row(2).dot(kUp), -1, 1e-9);
}

TEST(OrbitCamera, PanningByAHeightMovesThePivotOutByAHeight) {
  OrbitCamera camera = framed();
  const Eigen::Vector3d pivot = camera.pivot();
  camera.pan(0, 0.5, kAspect);
  EXPECT_NEAR(project(camera, pivot).y(), -1, 1e-9);  // Vulkan's y points down.
  camera.pan(0.25 * kAspect, 0, kAspect);
  EXPECT_NEAR(project(camera, pivot).x(), 0.5, 1e-9);
}

TEST(OrbitCamera, ZoomsByFactorsWithinSoundDistances) {
  OrbitCamera camera = framed();
  const double distance = camera.distance();
  camera.zoom(0.5);
  EXPECT_NEAR(camera.distance(), 0.5 * distance, 1e-12);
  for (int n = 0; n < 1000; ++n) {
    camera.zoom(0.5);
  }
  EXPECT_GT(camera.distance(), 0);
  EXPECT_TRUE(std::isfinite(project(camera, kBox.center()).norm()));
  for (int n = 0; n < 1000; ++n) {
    camera.zoom(2);
  }
  EXPECT_LT(camera.distance(), 1e4);
}

TEST(OrbitCamera, FramesABoxWithoutExtent) {
  OrbitCamera camera(kUp);
  const Eigen::AlignedBox3d point(Eigen::Vector3d(1, 2, 3), Eigen::Vector3d(1, 2, 3));
  camera.frame(point, kTopView, kAspect);
  EXPECT_TRUE(std::isfinite(camera.distance()));
  EXPECT_LT((camera.pivot() - point.center()).norm(), 1e-9);
}

}  // namespace
}  // namespace morphgrid
