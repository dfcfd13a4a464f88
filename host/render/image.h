#pragma once
#include <cstdint>
#include <vector>

namespace morphgrid {

/// A picture in memory.
struct Image {
  int width = 0;                   ///< In pixels.
  int height = 0;                  ///< In pixels.
  std::vector<std::uint8_t> rgba;  ///< 4 width height bytes, rows from the top.
};

}  // namespace morphgrid
