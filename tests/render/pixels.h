#pragma once
#include <array>
#include <string>
#include <vector>

#include "render/camera.h"
#include "render/image.h"

namespace morphgrid {

using Pixel = std::array<int, 3>;  ///< Red, green, blue.

Pixel pixelAt(const Image& image, int x, int y);
bool isWhite(const Pixel& pixel);

/// All that are not white.
std::vector<Pixel> coloredPixels(const Image& image);

/// The most often that a row of pixels changes between white and not: no more than twice where a
/// convex body is seen.
int mostOutlinesInARow(const Image& image);

/// The pixels that differ from white, from their first to their last.
struct PixelBox {
  int left, top, right, bottom;
};
PixelBox coloredBox(const Image& image);

/// Where a point of the world appears; in pixels from the image's top left corner.
glm::dvec2 pixelOf(const Image& image, const Camera& camera, const Eigen::Vector3d& point);

/// What the pixel at (x, y) shows of the plane z = 0.
glm::dvec2 floorPointOf(const Image& image, const Camera& camera, double x, double y);

/// The largest and the mean difference of a byte; images of one size.
struct ImageDifference {
  int largest;
  double mean;
};
ImageDifference differenceOf(const Image& a, const Image& b);

/// Throws std::runtime_error when the file cannot be read.
Image readPng(const std::string& path);

}  // namespace morphgrid
