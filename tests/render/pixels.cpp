#include "tests/render/pixels.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>

#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

namespace morphgrid {

Pixel pixelAt(const Image& image, int x, int y) {
  const std::uint8_t* bytes = &image.rgba.at(4 * (static_cast<std::size_t>(y) * image.width + x));
  return {bytes[0], bytes[1], bytes[2]};
}

bool isWhite(const Pixel& pixel) { return pixel == Pixel{255, 255, 255}; }

std::vector<Pixel> coloredPixels(const Image& image) {
  std::vector<Pixel> pixels;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const Pixel pixel = pixelAt(image, x, y);
      if (!isWhite(pixel)) {
        pixels.push_back(pixel);
      }
    }
  }
  return pixels;
}

int mostOutlinesInARow(const Image& image) {
  int most = 0;
  for (int y = 0; y < image.height; ++y) {
    int changes = 0;
    for (int x = 1; x < image.width; ++x) {
      changes += isWhite(pixelAt(image, x, y)) != isWhite(pixelAt(image, x - 1, y));
    }
    most = std::max(most, changes);
  }
  return most;
}

PixelBox coloredBox(const Image& image) {
  PixelBox box{image.width, image.height, -1, -1};
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      if (!isWhite(pixelAt(image, x, y))) {
        box = {std::min(box.left, x), std::min(box.top, y), std::max(box.right, x),
               std::max(box.bottom, y)};
      }
    }
  }
  return box;
}

glm::dvec2 pixelOf(const Image& image, const Camera& camera, const Eigen::Vector3d& point) {
  const glm::dvec4 clip = camera.clipFromWorld() * glm::dvec4(point.x(), point.y(), point.z(), 1);
  return {(clip.x / clip.w + 1) / 2 * image.width, (clip.y / clip.w + 1) / 2 * image.height};
}

glm::dvec2 floorPointOf(const Image& image, const Camera& camera, double x, double y) {
  const glm::dmat4 worldFromClip = glm::inverse(camera.clipFromWorld());
  const auto unproject = [&](double depth) {
    const glm::dvec4 point =
        worldFromClip * glm::dvec4(2 * x / image.width - 1, 2 * y / image.height - 1, depth, 1);
    return glm::dvec3(point) / point.w;
  };
  const glm::dvec3 near = unproject(0);
  const glm::dvec3 far = unproject(1);
  return glm::dvec2(near + near.z / (near.z - far.z) * (far - near));
}

ImageDifference differenceOf(const Image& a, const Image& b) {
  if (a.width != b.width || a.height != b.height) {
    throw std::runtime_error("the images differ in size");
  }
  ImageDifference difference{0, 0};
  for (std::size_t n = 0; n < a.rgba.size(); ++n) {
    const int off = std::abs(a.rgba[n] - b.rgba[n]);
    difference.largest = std::max(difference.largest, off);
    difference.mean += static_cast<double>(off) / static_cast<double>(a.rgba.size());
  }
  return difference;
}

Image readPng(const std::string& path) {
  Image image;
  std::uint8_t* bytes = stbi_load(path.c_str(), &image.width, &image.height, nullptr, 4);
  if (bytes == nullptr) {
    throw std::runtime_error(path + ": " + stbi_failure_reason());
  }
  image.rgba.assign(bytes, bytes + 4 * static_cast<std::size_t>(image.width) * image.height);
  stbi_image_free(bytes);
  return image;
}

}  // namespace morphgrid
