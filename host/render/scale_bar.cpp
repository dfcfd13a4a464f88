#include "render/scale_bar.h"

#include <fmt/format.h>

#include <cmath>

namespace morphgrid {

std::string LengthUnit::text(double length) const {
  const std::string& called = length == 1 && !nameOfOne.empty() ? nameOfOne : name;
  return called.empty() ? fmt::format("{:.4g}", length) : fmt::format("{:.4g} {}", length, called);
}

double roundLength(double largest) {
  const double power = std::pow(10, std::floor(std::log10(largest)));
  for (const double digit : {5.0, 2.0}) {
    if (digit * power <= largest) {
      return digit * power;
    }
  }
  return power;
}

std::optional<ScaleBar> scaleBarAt(const Camera& camera, const Eigen::Vector3d& pivot,
                                   double height, double longest, const LengthUnit& unit) {
  const glm::dvec4 at = camera.viewFromWorld * glm::dvec4(pivot.x(), pivot.y(), pivot.z(), 1);
  const double perPixel =
      unit.perSceneUnit * 2 * -at.z / (std::abs(camera.clipFromView[1][1]) * height);
  if (!(perPixel > 0) || !std::isfinite(perPixel)) {
    return std::nullopt;
  }
  const double length = roundLength(longest * perPixel);
  return ScaleBar{length / perPixel, unit.text(length)};
}

}  // namespace morphgrid
