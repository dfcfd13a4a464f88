#include <algorithm>
#include <cmath>

#include "gpu/offscreen_target.h"
#include "render/grid_painter.h"
#include "shared/share_color.h"
#include "tests/render/pixels.h"
#include "tests/render/sample_grids.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

constexpr int kPictureSide = 201;  // Odd: a pixel's middle is that of the picture.
constexpr double kStrutLength = 10;
constexpr double kTubeRadius = 0.12;  // 0.012 of the longer side, which is one spacing.
constexpr double kFarAway = 60;

/// A strut along each axis from the origin, their twins out of sight.
StrutGrid oneStrutEachWay() {
  StrutGrid grid = gridThrough({2, 2, 2}, [](int i, int j, int k) -> Eigen::Vector3d {
    return Eigen::Vector3d(i, j, k) * (i + j + k > 1 ? kFarAway : kStrutLength);
  });
  grid.spacing = kStrutLength;
  return grid;
}

/// Looks at `target` along `direction`.
Camera cameraTowards(const Eigen::Vector3d& target, const Eigen::Vector3d& direction,
                     double distance) {
  const Eigen::Vector3d back = -direction.normalized();
  const Eigen::Vector3d other = std::abs(back.z()) < 0.9 ? kUpwards : Eigen::Vector3d::UnitY();
  Eigen::Matrix3d rotation;
  rotation.row(0) = other.cross(back).normalized();
  rotation.row(1) = back.cross(Eigen::Vector3d(rotation.row(0)));
  rotation.row(2) = back;
  return cameraAt(target + distance * back, rotation, 1, distance / 100, 3 * distance);
}

/// How many pixels a length takes that lies at right angles to the sight, so far from the eye.
double pixelsOf(double length, double distance) {
  return length / distance / viewSlope(1) * kPictureSide / 2;
}

double fromMiddle(int x, int y) { return std::hypot(x - kPictureSide / 2, y - kPictureSide / 2); }

class TubePicture : public DeviceTest {
 protected:
  Image draw(const DeviceGrid& grid, const Camera& camera, StrutStyle style = StrutStyle::tubes,
             std::array<bool, 3> directions = {true, true, true}) {
    const StrutShares shares(device_, StrutValues(grid.shape()));
    const GridResources resources(device_, grid, &shares);
    OffscreenTarget target(device_, kPictureSide, kPictureSide, 4);
    const GridPainter painter(device_, target.pass());
    const LocalView view = viewOf(grid, Eigen::Isometry3d::Identity(), camera, kPictureSide);
    return {kPictureSide, kPictureSide, target.render([&](const CommandBuffer& commands) {
              painter.draw(commands, resources, {.style = style, .directions = directions}, view);
            })};
  }

  Image drawStrut(int direction, const Camera& camera) {
    std::array<bool, 3> directions{};
    directions[direction] = true;
    return draw({device_, oneStrutEachWay()}, camera, StrutStyle::tubes, directions);
  }
};

TEST_F(TubePicture, SeenAlongItsAxisCoversADiscOfItsRadius) {
  constexpr double kDistance = 2;
  const double radius = pixelsOf(kTubeRadius, kDistance);
  const double inscribed = radius * std::cos(M_PI / kTubeSides);
  for (int direction = 0; direction < 3; ++direction) {
    const Eigen::Vector3d axis = Eigen::Vector3d::Unit(direction);
    const Image image = drawStrut(direction, cameraTowards({0, 0, 0}, axis, kDistance));
    for (int y = 0; y < kPictureSide; ++y) {
      for (int x = 0; x < kPictureSide; ++x) {
        const double place = fromMiddle(x, y);
        ASSERT_FALSE(place < inscribed - 1 && isWhite(pixelAt(image, x, y))) << x << ", " << y;
        ASSERT_FALSE(place > radius + 1 && !isWhite(pixelAt(image, x, y))) << x << ", " << y;
      }
    }
    const double area = 0.5 * kTubeSides * std::sin(2 * M_PI / kTubeSides) * radius * radius;
    const auto covered = static_cast<double>(coloredPixels(image).size());
    EXPECT_NEAR(covered, area, 2 * M_PI * radius) << "direction " << direction;
  }
}

TEST_F(TubePicture, SeenFromItsOtherEndCoversItTheSame) {
  const Image image = drawStrut(0, cameraTowards({kStrutLength, 0, 0}, {-1, 0, 0}, 2));
  const double inscribed = pixelsOf(kTubeRadius, 2) * std::cos(M_PI / kTubeSides);
  EXPECT_GT(coloredPixels(image).size(), M_PI * inscribed * inscribed - 2 * M_PI * inscribed);
}

TEST_F(TubePicture, SeenFromTheSideIsTwoRadiiWide) {
  constexpr double kDistance = 1.5;
  const double width = pixelsOf(2 * kTubeRadius, kDistance);
  for (int direction = 0; direction < 3; ++direction) {
    const Eigen::Vector3d middle = kStrutLength / 2 * Eigen::Vector3d::Unit(direction);
    const Eigen::Vector3d from = Eigen::Vector3d::Unit((direction + 1) % 3);
    const Image image = drawStrut(direction, cameraTowards(middle, from, kDistance));
    const auto covered = static_cast<double>(coloredPixels(image).size());
    EXPECT_NEAR(covered / kPictureSide, width, 1.5) << "direction " << direction;
  }
}

/// What shaders/render/tube_light.glsl says of a cylinder across the picture, at a height of `t`
/// radii.
double expectedShade(double t) {
  const glm::dvec3 normal(0, t, std::sqrt(1 - t * t));  // In the view.
  const double lit = 0.62 + 0.38 * glm::dot(normal, glm::normalize(glm::dvec3(-0.45, 0.65, 0.62)));
  const double edge = 1 - normal.z * normal.z;
  return lit * (1 - 0.45 * edge * edge);
}

TEST_F(TubePicture, IsLitByItsNormal) {
  constexpr double kDistance = 3;  // Much more than the radius: lines of sight are parallel.
  const Image image = drawStrut(0, cameraTowards({kStrutLength / 2, 0, 0}, {0, 1, 0}, kDistance));
  const vec3 color = 255.0F * shareColor(0);
  // Halves: at the prism's corners normals are those of the cylinder.
  for (const double t : {-0.5, -0.25, 0.0, 0.25, 0.5}) {
    const int y =
        kPictureSide / 2 - static_cast<int>(std::lround(pixelsOf(t * kTubeRadius, kDistance)));
    for (const int x : {20, 100, 180}) {
      const Pixel pixel = pixelAt(image, x, y);
      for (int channel = 0; channel < 3; ++channel) {
        EXPECT_NEAR(pixel[channel], expectedShade(t) * color[channel], 8) << t << " at " << x;
      }
    }
  }
}

TEST_F(TubePicture, IsClosedFromEverySide) {
  for (const double turn : {0.0, 0.6, 1.5, 2.3, 3.1, 4.4, 5.7}) {
    for (const double tilt : {-1.4, -0.7, 0.1, 0.8}) {
      const Eigen::Vector3d sight(std::sin(tilt), std::cos(tilt) * std::cos(turn),
                                  std::cos(tilt) * std::sin(turn));
      const Image image = drawStrut(0, cameraTowards({0, 0, 0}, sight, 2));
      ASSERT_FALSE(coloredPixels(image).empty());
      ASSERT_LE(mostOutlinesInARow(image), 2) << "turn " << turn << ", tilt " << tilt;
    }
  }
}

TEST_F(TubePicture, LooksMuchLikeRibbonsFromAfar) {
  const StrutGrid grid = saddleGrid({9, 8, 3});
  const Camera camera = frameAll(grid.positions, kObliqueViewDirection, kUpwards, 1);
  const DeviceGrid onDevice(device_, grid);
  const Image tubes = draw(onDevice, camera);
  const Image ribbons = draw(onDevice, camera, StrutStyle::ribbons);
  EXPECT_LT(differenceOf(tubes, ribbons).mean, 6);
  EXPECT_GT(differenceOf(tubes, ribbons).mean, 0.1);
}

TEST_F(TubePicture, ThinTubesStayVisible) {
  const StrutGrid grid = flatGrid({200, 3, 1});
  const Image image = draw({device_, grid}, frameAll(grid.positions, {0, 0, -1}, {0, 1, 0}, 1));
  const PixelBox box = coloredBox(image);
  for (int x = box.left + 1; x < box.right; ++x) {
    for (const int j : {0, 1, 2}) {
      const int y = std::clamp(box.top + j * (box.bottom - box.top) / 2, 1, kPictureSide - 2);
      EXPECT_FALSE(isWhite(pixelAt(image, x, y - 1)) && isWhite(pixelAt(image, x, y)) &&
                   isWhite(pixelAt(image, x, y + 1)))
          << x << ", " << y;
    }
  }
}

TEST_F(TubePicture, StrutsWithoutLengthAreNotDrawn) {
  DeviceGrid grid(device_, oneStrutEachWay());
  grid.uploadPositions(Eigen::Matrix3Xd::Zero(3, grid.shape().vertexCount()));
  EXPECT_TRUE(coloredPixels(draw(grid, cameraTowards({0, 0, 0}, {1, 2, 3}, 2))).empty());
}

}  // namespace
}  // namespace morphgrid
