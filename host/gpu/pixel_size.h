#pragma once
#include <cstdint>

namespace morphgrid {

/// The size of an image, in pixels.
struct PixelSize {
  std::uint32_t width = 0;
  std::uint32_t height = 0;

  bool operator==(const PixelSize&) const = default;
};

}  // namespace morphgrid
