#include <filesystem>

#include "render/picture.h"
#include "render/strain_renderer.h"
#include "tests/render/pixels.h"
#include "tests/render/sample_grids.h"
#include "tests/support/folders.h"
#include "tests/support/validated_device.h"

namespace morphgrid {
namespace {

using GoldenPicture = DeviceTest;

// Devices differ in the pixels along edges; a wrong shape, colour or light moves the mean by more.
constexpr double kLargestMeanDifference = 2;

std::string differenceText(const Image& actual, const std::filesystem::path& golden) {
  if (!std::filesystem::exists(golden)) {
    return "there is no golden image";
  }
  const Image expected = readPng(golden.string());
  if (expected.width != actual.width || expected.height != actual.height) {
    return "the golden image has another size";
  }
  const double mean = differenceOf(actual, expected).mean;
  return mean <= kLargestMeanDifference
             ? ""
             : "the mean difference of a byte is " + std::to_string(mean) +
                   " of 255, allowed are " + std::to_string(kLargestMeanDifference);
}

void expectGolden(const Image& image, const std::string& name) {
  const std::filesystem::path golden = sourceFolder() / "tests/golden" / (name + ".png");
  const std::string difference = differenceText(image, golden);
  if (!difference.empty()) {
    const std::filesystem::path actual = binaryFolder() / (name + "_actual.png");
    writePng(actual, image);
    ADD_FAILURE() << difference << "; look at " << actual << "; if this is how it should look, "
                  << "copy it to " << golden;
  }
}

TEST_F(GoldenPicture, StrainedSaddle) {
  const StrutGrid grid = saddleGrid({13, 10, 3});
  const Camera camera = frameAll(grid.positions, kObliqueViewDirection, kUpwards, 256.0 / 192);
  StrainRenderer renderer(device_, 256, 192);
  const Image image =
      renderer.drawStruts(DeviceGrid(device_, grid), Eigen::Isometry3d::Identity(), camera);

  expectGolden(image, "strained_saddle");
}

TEST_F(GoldenPicture, SaddleBehindAVeil) {
  const StrutGrid grid = saddleGrid({13, 10, 3});
  const DeviceGrid surface(device_, grid), veil(device_, flatGrid({13, 10, 1}));
  const Eigen::Isometry3d centred(Eigen::Translation3d(-6, -4.5, 0.5));
  const Eigen::VectorXd shares = Eigen::VectorXd::LinSpaced(13 * 10, 0, 1);
  const Camera camera = frameAll(grid.positions, kObliqueViewDirection, kUpwards, 256.0 / 192);
  StrainRenderer renderer(device_, 256, 192);
  expectGolden(renderer.drawSurfaceShares({surface, Eigen::Isometry3d::Identity()}, shares,
                                          {veil, centred}, camera),
               "veiled_saddle");
}

}  // namespace
}  // namespace morphgrid
