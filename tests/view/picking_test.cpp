#include "view/picking.h"

#include <gtest/gtest.h>

#include "view/orbit_camera.h"

namespace morphgrid {
namespace {

const GridShape kShape{4, 3, 2};
const SceneArea kArea{100, 20, 600, 400};
constexpr double kReach = 5;

/// Unit cells in the plane, the second layer half a unit above.
Eigen::Matrix3Xd flatPositions() {
  Eigen::Matrix3Xd positions(3, kShape.vertexCount());
  for (int k = 0; k < kShape.layers; ++k) {
    for (int j = 0; j < kShape.verticesV; ++j) {
      for (int i = 0; i < kShape.verticesU; ++i) {
        positions.col(kShape.index(i, j, k)) = Eigen::Vector3d(i, j, 0.5 * k);
      }
    }
  }
  return positions;
}

class Picking : public testing::Test {
 protected:
  Picking() {
    OrbitCamera camera(Eigen::Vector3d(0, 0, 1));
    const Eigen::AlignedBox3d box(Eigen::Vector3d(0, 0, 0), Eigen::Vector3d(3, 2, 0.5));
    camera.frame(box, kTopView, kArea.aspect());
    clipFromWorld_ = camera.camera(box, kArea.aspect()).clipFromWorld();
  }

  std::optional<Strut> pickAt(const Eigen::Vector3d& point, double offsetX = 0) const {
    glm::dvec2 pixel = *pixelOf(point, clipFromWorld_, kArea);
    pixel.x += offsetX;
    return pickStrut(kShape, positions_, clipFromWorld_, kArea, pixel, kReach);
  }

  Eigen::Matrix3Xd positions_ = flatPositions();
  glm::dmat4 clipFromWorld_{};
};

TEST_F(Picking, PixelsLieInTheArea) {
  const glm::dvec2 middle = *pixelOf({1.5, 1, 0.25}, clipFromWorld_, kArea);
  EXPECT_NEAR(middle.x, 400, 1);
  EXPECT_NEAR(middle.y, 220, 1);
  // The top view has y upwards.
  EXPECT_LT(pixelOf({1.5, 2, 0.25}, clipFromWorld_, kArea)->y, middle.y);
}

TEST_F(Picking, TakesTheStrutOfTheUpperLayerNextToTheEye) {
  const auto strut = pickAt({1.5, 1, 0.5});
  ASSERT_TRUE(strut);
  EXPECT_EQ(strut->from, kShape.index(1, 1, 1));
  EXPECT_EQ(strut->to, kShape.index(2, 1, 1));
  EXPECT_EQ(strut->direction, Strut::Direction::u);
  EXPECT_EQ(strut->layer, 1);
}

TEST_F(Picking, ReachesAFewPixelsAside) {
  const Eigen::Vector3d onStrut(2, 0.5, 0.5);
  EXPECT_TRUE(pickAt(onStrut, kReach - 1));
  EXPECT_FALSE(pickAt(onStrut, kReach + 60));
}

TEST_F(Picking, SeesNothingBehindTheEye) {
  EXPECT_FALSE(pixelOf({1.5, 1, 1000}, clipFromWorld_, kArea));
  const glm::dvec2 middle(400, 220);
  Eigen::Matrix3Xd behind = positions_;
  behind.row(2).array() += 1000;
  EXPECT_FALSE(pickStrut(kShape, behind, clipFromWorld_, kArea, middle, 1e4));
}

}  // namespace
}  // namespace morphgrid
