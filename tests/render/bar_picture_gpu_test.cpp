#include <cmath>

#include "gpu/offscreen_target.h"
#include "grid/bar_section.h"
#include "render/grid_painter.h"
#include "render/strain_renderer.h"
#include "tests/render/pixels.h"
#include "tests/render/sample_grids.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

constexpr int kBarPictureSide = 201;  // Odd: a pixel's middle is that of the picture.
constexpr double kBarLength = 10;
constexpr double kBarWidth = 0.4;
constexpr double kBarHeight = 0.2;
constexpr double kPostWidth = 0.3;
constexpr double kNear = 2;
constexpr double kOutOfSight = 60;

/// Cells and layers of side kBarLength, as printed.
StrutGrid barsEachWay() {
  StrutGrid grid = gridThrough(
      {2, 2, 2}, [](int i, int j, int k) -> Vector3d { return kBarLength * Vector3d(i, j, k); });
  grid.spacing = kBarLength;
  grid.bars =
      Bars{rectangularSection({.width = kBarWidth, .height = kBarHeight}, 1),
           rectangularSection({.width = kPostWidth, .height = kPostWidth}, 1), grid.positions};
  return grid;
}

/// All joints turned alike.
JointRotations turnedAlike(const Eigen::Quaterniond& turn) { return turn.coeffs().replicate(1, 8); }

/// Looks at `target` along an axis, from a distance of kNear.
Camera cameraAlong(const Vector3d& target, const Vector3d& direction) {
  const Vector3d back = -direction.normalized();
  const Vector3d other = std::abs(back.z()) < 0.9 ? kUpwards : Vector3d::UnitY();
  Eigen::Matrix3d rotation;
  rotation.row(0) = other.cross(back).normalized();
  rotation.row(1) = back.cross(Vector3d(rotation.row(0)));
  rotation.row(2) = back;
  return cameraAt(target + kNear * back, rotation, 1, kNear / 100, 3 * kNear);
}

/// Of a length at right angles to the sight, so far from the eye.
double pixelsAcross(double length, double distance) {
  return length / distance / viewSlope(1) * kBarPictureSide / 2;
}

class BarPicture : public DeviceTest {
 protected:
  /// Struts along one direction: the one from the origin, its twins out of sight.
  Image draw(int direction, const Camera& camera,
             const JointRotations& rotations = unturnedJoints(8)) {
    const StrutGrid frame = barsEachWay();
    DeviceGrid grid(device_, frame);
    Eigen::Matrix3Xd positions = frame.positions;
    forEachVertex(frame.shape, [&](const GridPlace& place) {
      if (place.i + place.j + place.layer > 1) {
        positions.col(frame.shape.index(place)) *= kOutOfSight / kBarLength;
      }
    });
    grid.uploadPositions(positions, rotations);
    const GridResources resources(device_, grid);
    OffscreenTarget target(device_, kBarPictureSide, kBarPictureSide, 4);
    const GridPainter painter(device_, target.pass());
    const LocalView view = viewOf(grid, Eigen::Isometry3d::Identity(), camera, kBarPictureSide);
    GridLook look{.style = StrutStyle::tubes, .directions = {}};
    look.directions[direction] = true;
    return {kBarPictureSide, kBarPictureSide, target.render([&](const CommandBuffer& commands) {
              painter.draw(commands, resources, look, view);
            })};
  }

  /// The mean of what is covered of the picture's columns, or rows, in pixels: up to two too many,
  /// those of the edges.
  double thicknessOf(int direction, const Vector3d& sight,
                     const JointRotations& rotations = unturnedJoints(8)) {
    const Vector3d middle = kBarLength / 2 * Vector3d::Unit(direction);
    const Image image = draw(direction, cameraAlong(middle, sight), rotations);
    return static_cast<double>(coloredPixels(image).size()) / kBarPictureSide;
  }
};

TEST_F(BarPicture, ABarIsAsWideAndHighAsItsSection) {
  const Vector3d down(0, 0, -1);
  // The face that the eye sees is nearer than the bar's middle.
  const double wide = pixelsAcross(kBarWidth, kNear - kBarHeight / 2);
  const double high = pixelsAcross(kBarHeight, kNear - kBarWidth / 2);
  EXPECT_NEAR(thicknessOf(0, down), wide, 2);
  EXPECT_NEAR(thicknessOf(1, down), wide, 2);
  EXPECT_NEAR(thicknessOf(0, Vector3d::UnitY()), high, 2);
  EXPECT_NEAR(thicknessOf(1, Vector3d::UnitX()), high, 2);
}

TEST_F(BarPicture, APostIsAsWideAsItsSection) {
  const double wide = pixelsAcross(kPostWidth, kNear - kPostWidth / 2);
  EXPECT_NEAR(thicknessOf(2, Vector3d::UnitX()), wide, 2);
  EXPECT_NEAR(thicknessOf(2, Vector3d::UnitY()), wide, 2);
}

TEST_F(BarPicture, ABarTurnsWithItsJoints) {
  const Eigen::Quaterniond quarter(AngleAxisd(M_PI / 2, Vector3d::UnitX()));
  EXPECT_NEAR(thicknessOf(0, Vector3d(0, 0, -1), turnedAlike(quarter)),
              pixelsAcross(kBarHeight, kNear - kBarWidth / 2), 2);
}

TEST_F(BarPicture, ABarBendsBetweenItsJoints) {
  const double angle = 0.15;  // Of the ends to the chord.
  JointRotations rotations = unturnedJoints(8);
  rotations.col(0) = Eigen::Quaterniond(AngleAxisd(-angle, Vector3d::UnitY())).coeffs();
  rotations.col(1) = Eigen::Quaterniond(AngleAxisd(angle, Vector3d::UnitY())).coeffs();
  const double rise = kBarLength * std::tan(angle / 2) / 2;  // An arc's.
  const Image image = draw(0, cameraAlong({kBarLength / 2, 0, rise}, Vector3d::UnitY()), rotations);
  const PixelBox box = coloredBox(image);
  int top = 0;
  while (isWhite(pixelAt(image, kBarPictureSide / 2, top))) {
    ++top;
  }
  EXPECT_EQ(top, box.top);
  const double high = pixelsAcross(kBarHeight, kNear - kBarWidth / 2);
  EXPECT_NEAR(top, (kBarPictureSide - high) / 2, 2);
}

TEST_F(BarPicture, ALineOfBarsEndsHalfItsWidthBeyondItsLastJoint) {
  const double beyond = pixelsAcross(kBarWidth / 2, kNear - kBarHeight / 2);
  const Image begin = draw(0, cameraAlong({0, 0, 0}, {0, 0, -1}));
  EXPECT_NEAR(coloredBox(begin).left, kBarPictureSide / 2.0 - beyond, 1);
  const Image end = draw(0, cameraAlong({kBarLength, 0, 0}, {0, 0, -1}));
  EXPECT_NEAR(coloredBox(end).right, kBarPictureSide / 2.0 + beyond, 1);
}

TEST_F(BarPicture, IsClosedFromEverySide) {
  for (const double turn : {0.0, 0.6, 1.5, 2.3, 3.1, 4.4, 5.7}) {
    for (const double tilt : {-1.4, -0.7, 0.1, 0.8}) {
      const Vector3d sight(std::sin(tilt), std::cos(tilt) * std::cos(turn),
                           std::cos(tilt) * std::sin(turn));
      const Image image = draw(0, cameraAlong({0, 0, 0}, sight));
      ASSERT_FALSE(coloredPixels(image).empty());
      ASSERT_LE(mostOutlinesInARow(image), 2) << "turn " << turn << ", tilt " << tilt;
    }
  }
}

/// At joints the faces of bars lie in one plane; bars to +u are seen there.
TEST_F(BarPicture, BarsThatCrossDoNotFlicker) {
  StrutGrid frame = flatGrid({3, 3, 1});
  frame.bars = Bars{rectangularSection({.width = 0.3, .height = 0.3}, 1), {}, frame.positions};
  const DeviceGrid grid(device_, frame);
  StrutValues values(frame.shape);
  values.v.assign(values.v.size(), 1);
  const StrutShares shares(device_, values);
  const GridResources resources(device_, grid, &shares);
  OffscreenTarget target(device_, kBarPictureSide, kBarPictureSide, 1);
  const GridPainter painter(device_, target.pass());
  const Camera camera = frameAll(frame.positions, {0.2, 0.3, -1}, {0, 1, 0}, 1);
  const LocalView view = viewOf(grid, Eigen::Isometry3d::Identity(), camera, kBarPictureSide);
  const Image image{kBarPictureSide, kBarPictureSide,
                    target.render([&](const CommandBuffer& commands) {
                      painter.draw(commands, resources, {.style = StrutStyle::tubes}, view);
                    })};
  const auto shown = [&](double x, double y) {
    const glm::dvec2 pixel = pixelOf(image, camera, {x, y, 0.15});
    return pixelAt(image, static_cast<int>(pixel.x), static_cast<int>(pixel.y));
  };
  const Pixel alongU = shown(0.5, 1);
  ASSERT_GT(std::abs(shown(1, 0.5)[1] - alongU[1]), 50);
  for (const double x : {-0.1, -0.05, 0.0, 0.05, 0.1}) {
    for (const double y : {-0.1, -0.05, 0.0, 0.05, 0.1}) {
      EXPECT_NEAR(shown(1 + x, 1 + y)[1], alongU[1], 5) << x << ", " << y;
    }
  }
}

TEST_F(BarPicture, PicturesShowAFramesBars) {
  const StrutGrid frame = barsEachWay();
  const DeviceGrid grid(device_, frame);
  const Camera camera = frameAll(frame.positions, kObliqueViewDirection, kUpwards, 1);
  StrutGrid springs = frame;
  springs.bars.reset();
  StrainRenderer renderer(device_, kBarPictureSide, kBarPictureSide);
  const Image bars = renderer.drawStruts(grid, kUnmoved, camera);
  const Image ribbons = renderer.drawStruts({device_, springs}, kUnmoved, camera);
  EXPECT_GT(coloredPixels(bars).size(), 1.3 * static_cast<double>(coloredPixels(ribbons).size()));
}

}  // namespace
}  // namespace morphgrid
