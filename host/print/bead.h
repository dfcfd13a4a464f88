#pragma once
#include <numbers>

namespace morphgrid {

/// The cross-section of what the nozzle lays: a rectangle whose sides are half circles.
struct Bead {
  double width;   ///< mm, >= height.
  double height;  ///< mm, > 0.

  /// mm^2
  double area() const { return (width - height) * height + std::numbers::pi / 4 * height * height; }
  /// Between neighbouring lines that fill a solid: area() over height, mm.
  double pitch() const { return width - height * (1 - std::numbers::pi / 4); }
};

}  // namespace morphgrid
