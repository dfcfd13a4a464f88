#include "app/print_section.h"

#include <algorithm>

#include "app/scene.h"

namespace morphgrid {

ShrinkBounds shrinkBoundsOf(const Scene& scene, const std::optional<double>& mmPerUnit) {
  if (!scene.print || !mmPerUnit) {
    return {{scene.material.leastShrinkage, scene.design.maxShrinkage}};
  }
  return shrinkBoundsOf(scene.print->tools, *mmPerUnit);
}

MaterialRequest materialOf(const Scene& scene, const std::optional<double>& mmPerUnit) {
  MaterialRequest material = scene.material;
  if (scene.print && mmPerUnit && material.model != Model::paper) {
    const PrintedBars bars = printedBarsOf(scene.print->tools);
    const auto complete = [&](std::optional<double>& size, double printed) {
      size = size.value_or(printed / *mmPerUnit);
    };
    complete(material.barWidth, bars.width);
    complete(material.barHeight, bars.height);
    complete(material.postWidth, bars.post);
    complete(material.jointRadius, bars.joint);
  }
  return material;
}

std::optional<double> strutThicknessOf(const Scene& scene, const std::optional<double>& mmPerUnit) {
  const std::optional<double>& own = scene.design.strutThickness;
  if (own || !scene.print || !mmPerUnit) {
    return own;
  }
  const PrintedBars bars = printedBarsOf(scene.print->tools);
  return std::max(bars.width, bars.height) / *mmPerUnit;
}

DesignBounds designBoundsOf(const Scene& scene) {
  return {.hasPrint = scene.print.has_value(), .isEnforced = scene.design.enforceShrinkage};
}

std::optional<double> mmPerUnitOf(const Scene& scene, const Eigen::Matrix2Xd& sheet) {
  if (!scene.print) {
    return std::nullopt;
  }
  const PrintTools& tools = scene.print->tools;
  return tools.request.scale ? *tools.request.scale : largestScale(tools, sheet);
}

}  // namespace morphgrid
