#include <algorithm>

#include "render/strain_renderer.h"
#include "solve/jacobi_solver.h"
#include "tests/render/pixels.h"
#include "tests/render/sample_grids.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

class StrutPicture : public DeviceTest {
 protected:
  Image draw(const StrutGrid& grid, int width = 200, int height = 150, int samples = 4) {
    const Camera camera = frameAll(grid.positions, kObliqueViewDirection, kUpwards,
                                   static_cast<double>(width) / height);
    StrainRenderer renderer(device_, width, height, samples);
    return renderer.drawStruts(DeviceGrid(device_, grid), kUnmoved, camera);
  }
};

void expectCentered(const Image& image) {
  const PixelBox box = coloredBox(image);
  EXPECT_NEAR(box.left + box.right, image.width - 1, 3);
  EXPECT_NEAR(box.top + box.bottom, image.height - 1, 3);
  EXPECT_GT(std::max<double>(box.right - box.left, 0) / image.width +
                std::max<double>(box.bottom - box.top, 0) / image.height,
            0.9);
}

/// Colours that are `hue`, shaded, and mixed with white at their edges.
void expectPure(const Image& image, int hue) {
  const auto pixels = coloredPixels(image);
  ASSERT_GT(pixels.size(), 100U);
  for (const Pixel& pixel : pixels) {
    ASSERT_NEAR(pixel[(hue + 1) % 3], pixel[(hue + 2) % 3], 2);
    ASSERT_GE(pixel[hue], pixel[(hue + 1) % 3] - 2);
  }
  const auto strongest = std::min_element(pixels.begin(), pixels.end(), [&](auto& a, auto& b) {
    return a[(hue + 1) % 3] - a[hue] < b[(hue + 1) % 3] - b[hue];
  });
  EXPECT_LT((*strongest)[(hue + 1) % 3], 3);
}

TEST_F(StrutPicture, UnstrainedGridIsGreenAndCentered) {
  const Image image = draw(flatGrid({6, 5, 3}));
  expectPure(image, 1);
  expectCentered(image);
}

TEST_F(StrutPicture, GridStretchedBy20PercentIsRed) {
  expectPure(draw(flatGrid({6, 5, 2}, 1, 0.2)), 0);
  expectPure(draw(flatGrid({6, 5, 2}, 1, 0.5)), 0);
}

TEST_F(StrutPicture, GridShortenedBy20PercentIsDarkBlue) {
  const Image image = draw(flatGrid({6, 5, 2}, 1, -0.2));
  int full = 0;
  for (const Pixel& pixel : coloredPixels(image)) {
    ASSERT_NEAR(pixel[0], pixel[1], 2);
    if (pixel[0] < 3) {
      ++full;
      EXPECT_LE(pixel[2], 128);
      EXPECT_GE(pixel[2], 15);
    }
  }
  EXPECT_GT(full, 100);
}

TEST_F(StrutPicture, ColorDoesNotDependOnTheUnitOfLength) {
  for (const double unit : {1e-3, 1.0, 1e4}) {
    expectPure(draw(flatGrid({4, 4, 3}, unit)), 1);
  }
}

TEST_F(StrutPicture, EachStrutHasItsOwnColor) {
  StrutGrid grid = flatGrid({2, 2, 1});
  grid.rest.u[0] = 1 / 1.2;
  const Camera camera = frameAll(grid.positions, {0, 0, -1}, {0, 1, 0}, 1);
  StrainRenderer renderer(device_, 300, 300);
  const Image image = renderer.drawStruts(DeviceGrid(device_, grid), kUnmoved, camera);
  const auto colorAt = [&](double x, double y) {
    const glm::dvec2 place = pixelOf(image, camera, {x, y, 0});
    return pixelAt(image, static_cast<int>(place.x), static_cast<int>(place.y));
  };
  EXPECT_GT(colorAt(0.5, 0)[0], 170);
  EXPECT_LT(colorAt(0.5, 0)[1], 3);
  for (const Pixel& pixel : {colorAt(0.5, 1), colorAt(0, 0.5), colorAt(1, 0.5)}) {
    EXPECT_GT(pixel[1], 170);
    EXPECT_LT(pixel[0], 3);
  }
  EXPECT_TRUE(isWhite(colorAt(0.5, 0.5)));
}

TEST_F(StrutPicture, SizesAreArbitrary) {
  for (const auto& [width, height] : {std::pair(1, 1), {65, 33}, {33, 217}, {401, 3}}) {
    const Image image = draw(flatGrid({3, 7, 2}), width, height);
    EXPECT_EQ(image.width, width);
    EXPECT_EQ(image.height, height);
    EXPECT_EQ(image.rgba.size(), 4 * std::size_t(width) * height);
    EXPECT_FALSE(coloredPixels(image).empty());
  }
}

TEST_F(StrutPicture, OneSampleLooksLikeFour) {
  const StrutGrid grid = saddleGrid({9, 8, 3});
  EXPECT_LT(differenceOf(draw(grid, 320, 240, 1), draw(grid, 320, 240, 4)).mean, 8);
}

TEST_F(StrutPicture, SeenFromBelowAndAlongTheLayers) {
  const StrutGrid grid = flatGrid({6, 5, 3});
  const DeviceGrid deviceGrid(device_, grid);
  StrainRenderer renderer(device_, 120, 90);
  for (const Eigen::Vector3d& view : {Eigen::Vector3d(0.4, 0.8, 0.6), {1, 0, 0}, {0, 0, 1}}) {
    const Camera camera = frameAll(grid.positions, view, kUpwards, 120.0 / 90);
    expectPure(renderer.drawStruts(deviceGrid, kUnmoved, camera), 1);
  }
}

TEST_F(StrutPicture, ThinStrutsOfADenseGridStayVisible) {
  const Image image = draw(flatGrid({200, 3, 1}), 300, 200);
  EXPECT_GT(coloredPixels(image).size(), 280U * 2);
  expectPure(image, 1);
}

TEST_F(StrutPicture, MovesWithTheGrid) {
  const StrutGrid grid = saddleGrid({7, 6, 2});
  const DeviceGrid deviceGrid(device_, grid);
  StrainRenderer renderer(device_, 160, 120);
  const Camera camera = frameAll(grid.positions, kObliqueViewDirection, kUpwards, 160.0 / 120);
  Eigen::Isometry3d motion(Eigen::AngleAxisd(1.1, Eigen::Vector3d(1, 2, 3).normalized()));
  motion.pretranslate(Eigen::Vector3d(40, -30, 20));
  StrutGrid moved = grid;
  moved.positions = motion * grid.positions;
  const DeviceGrid movedDeviceGrid(device_, moved);
  const Image image = renderer.drawStruts(deviceGrid, kUnmoved, camera);
  const Image movedBack = renderer.drawStruts(movedDeviceGrid, motion.inverse(), camera);
  EXPECT_LT(differenceOf(image, movedBack).mean, 0.5);
}

TEST_F(StrutPicture, ShowsWhatTheSolverWroteLast) {
  const StrutGrid grid = saddleGrid({9, 8, 3});
  DeviceGrid deviceGrid(device_, grid);
  JacobiSolver solver(device_, grid, deviceGrid);
  StrainRenderer renderer(device_, 160, 120);
  const Camera camera = frameAll(grid.positions, kObliqueViewDirection, kUpwards, 160.0 / 120);
  const Image before = renderer.drawStruts(deviceGrid, kUnmoved, camera);
  solver.sweep(3);
  const Image after = renderer.drawStruts(deviceGrid, kUnmoved, camera);
  EXPECT_GT(differenceOf(before, after).mean, 1);
  StrutGrid solved = grid;
  solved.positions = deviceGrid.downloadPositions();
  const DeviceGrid copy(device_, solved);
  EXPECT_LT(differenceOf(after, renderer.drawStruts(copy, kUnmoved, camera)).mean, 0.5);
}

}  // namespace
}  // namespace morphgrid
