#include "design/material.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/error.h"
#include "design/joint_loads.h"
#include "grid/bar_section.h"

namespace morphgrid {
namespace {

constexpr double kDefaultSlenderness = 5;  // Mean rest length over the bars' width.
constexpr double kJointShare = 0.25;       // Of the bars' width.
constexpr double kThickest = 1.0 / 3;      // Of the shortest strut.

double meanOfLateral(const StrutGrid& grid, const StrutValues& values) {
  double sum = 0;
  forEachLateralStrut(grid.shape, [&](const Strut& strut) { sum += valueAt(values, strut); });
  return sum / grid.shape.lateralStrutCount();
}

double shortestRest(const StrutGrid& grid) {
  double shortest = std::numeric_limits<double>::infinity();
  forEachStrut(grid.shape, [&](const Strut& strut) {
    shortest = std::min(shortest, valueAt(grid.rest, strut));
  });
  return shortest;
}

}  // namespace

BarSizes barSizesOf(const MaterialRequest& material, double meanLength) {
  const double width = material.barWidth.value_or(meanLength / kDefaultSlenderness);
  return {.width = width,
          .height = material.barHeight.value_or(width),
          .post = material.postWidth.value_or(width),
          .joint = material.jointRadius.value_or(kJointShare * width)};
}

void weld(StrutGrid& grid, const MaterialRequest& material) {
  if (material.model != Model::frame) {
    return;
  }
  const BarSizes sizes = barSizesOf(material, meanOfLateral(grid, grid.rest));
  if (2 * sizes.joint >= shortestRest(grid)) {
    throw InputError(fmt::format(
        "material.joint_radius must be less than half of the shortest strut, {:.3g}, got {:.3g}: "
        "lower it or material.bar_width",
        shortestRest(grid) / 2, sizes.joint));
  }
  const double modulus = 2 * meanOfLateral(grid, grid.stiffness) * meanOfLateral(grid, grid.rest) /
                         (sizes.width * sizes.height);
  const auto section = [&](double across, double high) {
    return rectangularSection({.width = across,
                               .height = high,
                               .poisson = material.poisson,
                               .joint = sizes.joint,
                               .isShearing = false},
                              modulus);
  };
  grid.bars =
      Bars{section(sizes.width, sizes.height), section(sizes.post, sizes.post), grid.positions};
  grid.bars->loads = jointLoads(grid, material);
}

std::vector<std::string> adviseOnBars(const StrutGrid& grid, const MaterialRequest& material) {
  std::vector<std::string> notices;
  if (material.model != Model::frame) {
    return notices;
  }
  const BarSizes sizes = barSizesOf(material, meanOfLateral(grid, grid.rest));
  const double width = sizes.width;
  const double height = sizes.height;
  const double layerSpacing = grid.shape.layers > 1 ? grid.rest.w.front() : 0;
  if (grid.shape.layers > 1 && height > layerSpacing) {
    notices.push_back(fmt::format(
        "bars are {:.3g} high but the layers only {:.3g} apart, so they would overlap: lower "
        "material.bar_height or raise grid.layer_spacing",
        height, layerSpacing));
  }
  double shortest = std::numeric_limits<double>::infinity();
  forEachLateralStrut(grid.shape, [&](const Strut& strut) {
    shortest = std::min(shortest, valueAt(grid.rest, strut));
  });
  if (width > kThickest * shortest) {
    notices.push_back(fmt::format(
        "bars are {:.3g} wide, more than a third of the shortest strut ({:.3g}), too stocky for "
        "beams: lower material.bar_width or grid.nodes_long",
        width, shortest));
  }
  if (grid.bars && grid.bars->loads && holdApart(*grid.bars->loads, grid.shape)) {
    notices.emplace_back(
        "material.supports hold joints apart, between which the grid cannot shrink: hold one, or "
        "set material.slide");
  }
  return notices;
}

}  // namespace morphgrid
