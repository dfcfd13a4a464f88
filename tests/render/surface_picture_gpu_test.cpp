#include <algorithm>

#include "grid/surface_mesh.h"
#include "render/strain_renderer.h"
#include "tests/render/pixels.h"
#include "tests/render/sample_grids.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

constexpr int kPictureWidth = 203;
constexpr int kPictureHeight = 151;

class SurfacePicture : public DeviceTest {
 protected:
  Camera cameraFor(const StrutGrid& grid,
                   const Eigen::Vector3d& view = kObliqueViewDirection) const {
    return frameAll(grid.positions, view, kUpwards,
                    static_cast<double>(kPictureWidth) / kPictureHeight);
  }
  Image draw(const StrutGrid& grid, const Camera& camera, int samples = 4) {
    StrainRenderer renderer(device_, kPictureWidth, kPictureHeight, samples);
    return renderer.drawSurface(DeviceGrid(device_, grid), kUnmoved, camera);
  }
};

/// The middle layer alone.
StrutGrid middleOf(const StrutGrid& grid) {
  const Eigen::Matrix3Xd points = middleLayer(grid.shape, grid.positions);
  const GridShape shape{grid.shape.verticesU, grid.shape.verticesV, 1};
  return gridThrough(shape, [&](int i, int j, int) -> Eigen::Vector3d {
    return points.col(shape.index(i, j, 0));
  });
}

TEST_F(SurfacePicture, FlatLayerCoversExactlyItsPixels) {
  for (const GridShape& shape : {GridShape{2, 2, 1}, GridShape{3, 2, 1}, GridShape{14, 9, 1}}) {
    const StrutGrid grid = flatGrid(shape);
    const Camera camera = cameraFor(grid);
    const Image image = draw(grid, camera);
    const double pixel = 2.5 * (shape.verticesU + shape.verticesV) / kPictureWidth;
    for (int y = 0; y < kPictureHeight; ++y) {
      for (int x = 0; x < kPictureWidth; ++x) {
        const glm::dvec2 point = floorPointOf(image, camera, x + 0.5, y + 0.5);
        const double inside = std::min(
            {point.x, point.y, shape.verticesU - 1 - point.x, shape.verticesV - 1 - point.y});
        if (std::abs(inside) > pixel) {
          ASSERT_EQ(isWhite(pixelAt(image, x, y)), inside < 0) << x << ", " << y;
        }
      }
    }
  }
}

TEST_F(SurfacePicture, CurvedLayerCoversTheCatmullRomSurface) {
  const StrutGrid grid = saddleGrid({4, 5, 1});
  const Camera camera = cameraFor(grid);
  const Image image = draw(grid, camera);
  const SurfaceMesh mesh = tessellate({4, 5, 1}, grid.positions, 60);
  std::vector<bool> covered(kPictureWidth * kPictureHeight);
  for (Eigen::Index n = 0; n < mesh.vertices.cols(); ++n) {
    const glm::dvec2 place = pixelOf(image, camera, mesh.vertices.col(n));
    covered[static_cast<int>(place.y) * kPictureWidth + static_cast<int>(place.x)] = true;
  }
  int agreeing = 0;
  for (int n = 0; n < kPictureWidth * kPictureHeight; ++n) {
    agreeing += covered[n] && !isWhite(pixelAt(image, n % kPictureWidth, n / kPictureWidth));
  }
  // They differ where a pixel is covered in part.
  const double coloredCount = static_cast<double>(coloredPixels(image).size());
  const auto coveredCount = static_cast<double>(std::count(covered.begin(), covered.end(), true));
  EXPECT_GT(coloredCount, 4000);
  EXPECT_GT(agreeing, 0.985 * coloredCount);
  EXPECT_GT(agreeing, 0.985 * coveredCount);
}

TEST_F(SurfacePicture, ShowsTheMiddleLayer) {
  for (const int layers : {1, 2, 3, 4, 5}) {
    const StrutGrid grid = saddleGrid({6, 7, layers});
    const Camera camera = cameraFor(grid);
    const Image image = draw(grid, camera);
    EXPECT_LT(differenceOf(image, draw(middleOf(grid), camera)).mean, 0.3) << layers << " layers";
    EXPECT_GT(coloredPixels(image).size(), 2000U);
  }
}

TEST_F(SurfacePicture, IsLitFromBothSides) {
  const StrutGrid grid = flatGrid({8, 8, 1});
  for (const Eigen::Vector3d& view : {Eigen::Vector3d(0.3, 0.5, -0.8), {0.3, 0.5, 0.8}}) {
    const Camera camera = cameraFor(grid, view);
    const Image image = draw(grid, camera);
    const glm::dvec2 place = pixelOf(image, camera, {3.5, 3.5, 0});
    const Pixel pixel = pixelAt(image, static_cast<int>(place.x), static_cast<int>(place.y));
    EXPECT_GT(*std::min_element(pixel.begin(), pixel.end()), 80);
    const bool fromAbove = view.z() < 0;
    EXPECT_EQ(pixel[2] > pixel[0], fromAbove) << "front bluish, back reddish";
  }
}

TEST_F(SurfacePicture, IsolinesRunAlongTheStruts) {
  const StrutGrid grid = flatGrid({5, 5, 1});
  const Camera camera = cameraFor(grid, {0, 0, -1});
  const Image image = draw(grid, camera);
  const auto brightnessAt = [&](double x, double y) {
    const glm::dvec2 place = pixelOf(image, camera, {x, y, 0});
    return pixelAt(image, static_cast<int>(place.x), static_cast<int>(place.y))[1];
  };
  for (int n = 1; n < 4; ++n) {
    EXPECT_LT(brightnessAt(n, 1.5), brightnessAt(n + 0.5, 1.5) - 8);
    EXPECT_LT(brightnessAt(1.5, n), brightnessAt(1.5, n + 0.5) - 8);
  }
}

TEST_F(SurfacePicture, PoleHasNoHoles) {
  const GridShape shape{9, 7, 1};  // The side i = 0 is a circle of 1/1000 of the disc.
  const StrutGrid grid = gridThrough(shape, [](int i, int j, int) {
    const double radius = 0.008 + i, angle = 0.5 * j;
    return Eigen::Vector3d(radius * std::cos(angle), radius * std::sin(angle), 0);
  });
  const Camera camera = cameraFor(grid, {0, 0, -1});
  const Image image = draw(grid, camera);
  const glm::dvec2 place = pixelOf(image, camera, {0.15, 0.2, 0});
  EXPECT_FALSE(isWhite(pixelAt(image, static_cast<int>(place.x), static_cast<int>(place.y))));
}

TEST_F(SurfacePicture, OneSampleLooksLikeFour) {
  const StrutGrid grid = saddleGrid({9, 8, 2});
  const Camera camera = cameraFor(grid);
  EXPECT_LT(differenceOf(draw(grid, camera, 1), draw(grid, camera, 4)).mean, 2);
}

}  // namespace
}  // namespace morphgrid
