#include <algorithm>

#include "gpu/offscreen_target.h"
#include "render/grid_painter.h"
#include "render/strain_renderer.h"
#include "shared/share_color.h"
#include "tests/render/pixels.h"
#include "tests/render/sample_grids.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

constexpr int kSide = 200;

/// From straight above, y up.
Camera cameraAbove(const StrutGrid& grid) {
  return frameAll(grid.positions, {0, 0, -1}, {0, 1, 0}, 1);
}

Pixel colorAt(const Image& image, const Camera& camera, const Eigen::Vector3d& point) {
  const glm::dvec2 place = pixelOf(image, camera, point);
  return pixelAt(image, static_cast<int>(place.x), static_cast<int>(place.y));
}

/// Light may darken a colour, but neither by much nor change its hue.
void expectColor(const Pixel& pixel, double share, int tolerance = 4) {
  const vec3 color = 255.0F * shareColor(static_cast<float>(share));
  const float brightest = std::max({color.r, color.g, color.b});
  const double light = std::max({pixel[0], pixel[1], pixel[2]}) / brightest;
  EXPECT_GT(light, 0.6) << share;
  EXPECT_LT(light, 1.05) << share;
  for (int channel = 0; channel < 3; ++channel) {
    EXPECT_NEAR(pixel[channel], light * color[channel], tolerance) << share;
  }
}

class SharePicture : public DeviceTest {
 protected:
  Image drawStruts(const StrutGrid& grid, const StrutValues& shares, const Camera& camera) {
    return renderer.drawStrutShares(DeviceGrid(device_, grid), shares, camera);
  }
  Image drawSurface(const StrutGrid& grid, const Eigen::VectorXd& shares, const StrutGrid& veil,
                    const Camera& camera, const Eigen::Isometry3d& worldFromVeil = kUnmoved) {
    const DeviceGrid surface(device_, grid), over(device_, veil);
    return renderer.drawSurfaceShares({surface, kUnmoved}, shares, {over, worldFromVeil}, camera);
  }

  StrainRenderer renderer{device_, kSide, kSide};
};

TEST_F(SharePicture, EachStrutHasTheColorOfItsShare) {
  const StrutGrid grid = flatGrid({3, 2, 1});
  StrutValues shares(grid.shape);
  shares.u = {0, 0.25, 0, 0.5, 1, 0};
  shares.v = {-0.1, 0.75, 1.1, 0, 0, 0};
  const Camera camera = cameraAbove(grid);
  const Image image = drawStruts(grid, shares, camera);
  expectColor(colorAt(image, camera, {0.5, 0, 0}), 0);
  expectColor(colorAt(image, camera, {1.5, 0, 0}), 0.25);
  expectColor(colorAt(image, camera, {0.5, 1, 0}), 0.5);
  expectColor(colorAt(image, camera, {1.5, 1, 0}), 1);
  expectColor(colorAt(image, camera, {0, 0.5, 0}), -0.1);
  expectColor(colorAt(image, camera, {1, 0.5, 0}), 0.75);
  expectColor(colorAt(image, camera, {2, 0.5, 0}), 1.1);
  EXPECT_TRUE(isWhite(colorAt(image, camera, {0.5, 0.5, 0})));
}

TEST_F(SharePicture, VerticalStrutsAreLeftOut) {
  const StrutGrid grid = flatGrid({2, 2, 2}, 1);
  const Camera camera = frameAll(grid.positions, {0, 1, 0}, {0, 0, 1}, 1);
  const Image image = drawStruts(grid, StrutValues(grid.shape), camera);
  EXPECT_TRUE(isWhite(colorAt(image, camera, {0, 0, 0.15})));
  EXPECT_FALSE(isWhite(colorAt(image, camera, {0.5, 0, 0.3})));
}

TEST_F(SharePicture, SurfaceIsLinearBetweenItsVertices) {
  const StrutGrid grid = flatGrid({3, 3, 1});
  Eigen::VectorXd shares(9);
  shares << 0, 1, 0, 0, 1, 0, 0, 1, 0;  // A spline would leave 0 .. 1 beside the maximum.
  const Camera camera = cameraAbove(grid);
  const StrutGrid below = flatGrid({3, 3, 1}, 0.9);
  const Image image =
      drawSurface(grid, shares, below, camera, Eigen::Isometry3d(Eigen::Translation3d(0, 0, -1)));
  for (const double x : {0.07, 0.25, 0.5, 0.8, 1.25, 1.9}) {
    expectColor(colorAt(image, camera, {x, 0.4, 0}), x < 1 ? x : 2 - x, 8);
  }
}

TEST_F(SharePicture, SurfaceThroughFewerVerticesHasTheirShares) {
  const StrutGrid grid = flatGrid({12, 9, 2});
  Eigen::VectorXd shares(12 * 9);
  for (int n = 0; n < shares.size(); ++n) {
    shares[n] = n % 12 / 11.0;
  }
  const DeviceGrid onDevice(device_, grid);
  const StrutShares uploaded(device_, StrutValues(grid.shape), shares);
  const GridResources resources(device_, onDevice, &uploaded);
  OffscreenTarget target(device_, kSide, kSide, 4);
  const GridPainter painter(device_, target.pass());
  const Camera camera = cameraAbove(grid);
  const Image image{kSide, kSide, target.render([&](const CommandBuffer& commands) {
                      painter.draw(commands, resources, {.isSurface = true, .mostQuads = 20},
                                   viewOf(onDevice, kUnmoved, camera, kSide));
                    })};
  for (const double x : {0.4, 2.3, 5.2, 8.6, 10.4}) {
    expectColor(colorAt(image, camera, {x, 1.4, 0.15}), x / 11, 8);
  }
}

TEST_F(SharePicture, VeilDimsWhatIsBehindItAndHidesNothing) {
  const StrutGrid grid = flatGrid({3, 3, 1});
  const StrutGrid veil = flatGrid({3, 3, 1}, 0.5);  // Over one quarter.
  const Camera camera = cameraAbove(grid);
  const Eigen::VectorXd shares = Eigen::VectorXd::Constant(9, 0.5);
  const auto drawAt = [&](double height) {
    return drawSurface(grid, shares, veil, camera,
                       Eigen::Isometry3d(Eigen::Translation3d(0, 0, height)));
  };
  const Image above = drawAt(0.1), below = drawAt(-0.1);
  const Eigen::Vector3d covered(0.3, 0.3, 0), bare(1.6, 1.6, 0);
  expectColor(colorAt(below, camera, covered), 0.5);
  expectColor(colorAt(above, camera, bare), 0.5);
  const Pixel veiled = colorAt(above, camera, covered), plain = colorAt(below, camera, covered);
  EXPECT_LT(veiled[0], plain[0] - 10);
  EXPECT_GT(veiled[0], plain[0] - 60);
  EXPECT_GT(veiled[2], plain[2]) << "the veil is bluer";
}

TEST_F(SharePicture, VeilIsSeenBesideTheSurface) {
  const StrutGrid grid = flatGrid({3, 3, 1}, 0.5);
  const StrutGrid veil = flatGrid({3, 3, 1});
  const Camera camera = cameraAbove(veil);
  const Image image = drawSurface(grid, Eigen::VectorXd::Zero(9), veil, camera);
  const Pixel beside = colorAt(image, camera, {1.6, 1.6, 0});
  EXPECT_FALSE(isWhite(beside));
  EXPECT_GT(*std::min_element(beside.begin(), beside.end()), 190);
  for (std::size_t alpha = 3; alpha < image.rgba.size(); alpha += 4) {
    ASSERT_EQ(image.rgba[alpha], 255);
  }
}

}  // namespace
}  // namespace morphgrid
