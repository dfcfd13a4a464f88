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

double shortestLateralRest(const StrutGrid& grid) {
  double shortest = std::numeric_limits<double>::infinity();
  forEachLateralStrut(grid.shape, [&](const Strut& strut) {
    shortest = std::min(shortest, valueAt(grid.rest, strut));
  });
  return shortest;
}

/// Of a corner between bars of lengths a, b that are welded and free at their ends: springs with
/// this weight resist its shear as the bars do. bendingA, bendingB: EI.
double cornerWeight(double a, double bendingA, double b, double bendingB) {
  return 1.5 * (a * a + b * b) / ((a / bendingA + b / bendingB) * a * a * b * b);
}

/// Springs with the stiffness of bars, and corners that resist as bars bend. length: mean rest
/// length of the lateral ones.
void weighAsBars(StrutGrid& grid, const Bars& bars, double length) {
  const double inPlane = bars.lateral.bendingN;
  grid.weights.angle = cornerWeight(length, inPlane, length, inPlane);
  grid.printedCorners = bars.printed;
  if (grid.shape.layers == 1) {
    return;
  }
  forEachStrut(grid.shape, [&](const Strut& strut) {
    if (!strut.isLateral()) {
      valueAt(grid.stiffness, strut) = bars.upright.stretching / (2 * valueAt(grid.rest, strut));
    }
  });
  const double height = grid.rest.w.front();
  grid.weights.postAngle =
      cornerWeight(length, bars.lateral.bendingB, height, bars.upright.bendingN);
}

}  // namespace

BarSizes barSizesOf(const MaterialRequest& material, double meanLength) {
  const double width = material.barWidth.value_or(meanLength / kDefaultSlenderness);
  return {.width = width,
          .height = material.barHeight.value_or(width),
          .post = material.postWidth.value_or(width),
          .joint = material.jointRadius.value_or(kJointShare * width)};
}

std::optional<BarSizes> barSizesOf(const StrutGrid& grid, const MaterialRequest& material) {
  return material.model == Model::paper
             ? std::nullopt
             : std::optional(barSizesOf(material, meanOfLateral(grid, grid.rest)));
}

MaterialRequest withSizes(MaterialRequest material, double meanLength) {
  const BarSizes sizes = barSizesOf(material, meanLength);
  material.barWidth = sizes.width;
  material.barHeight = sizes.height;
  material.postWidth = sizes.post;
  material.jointRadius = sizes.joint;
  return material;
}

void applyMaterial(StrutGrid& grid, const MaterialRequest& material) {
  if (material.model == Model::paper) {
    return;
  }
  const double length = meanOfLateral(grid, grid.rest);
  const BarSizes sizes = barSizesOf(material, length);
  const double modulus =
      2 * meanOfLateral(grid, grid.stiffness) * length / (sizes.width * sizes.height);
  const auto section = [&](double width, double height, double joint) {
    return rectangularSection({.width = width,
                               .height = height,
                               .poisson = material.poisson,
                               .joint = joint,
                               .isShearing = false},
                              modulus);
  };
  // Above and below a joint no more of a post is rigid than the bars are high.
  const Bars bars{section(sizes.width, sizes.height, sizes.joint),
                  section(sizes.post, sizes.post, std::min(sizes.joint, sizes.height / 2)),
                  grid.positions};
  if (material.model == Model::bars) {
    weighAsBars(grid, bars, length);
    return;
  }
  if (const double shortest = shortestLateralRest(grid); 2 * sizes.joint >= shortest) {
    throw InputError(fmt::format(
        "material.joint_radius must be less than half of the shortest strut, {:.3g}, got {:.3g}: "
        "lower it or material.bar_width (with [print] it is a hub's radius: a larger print.scale "
        "or fewer grid.nodes_long)",
        shortest / 2, sizes.joint));
  }
  if (const double post = grid.rest.w.front(); 2 * bars.upright.joint >= post) {
    throw InputError(fmt::format(
        "joints leave nothing of a post that bends: the lower of material.bar_height "
        "({:.3g}) and twice material.joint_radius (2 x {:.3g}) must be less than the "
        "layers are apart, {:.3g}: lower one, or raise grid.layer_spacing (with [print] "
        "they are those of struts and hubs: a larger print.scale or fewer "
        "print.passes)",
        sizes.height, sizes.joint, post));
  }
  grid.bars = bars;
  grid.bars->loads = jointLoads(grid, material);
}

std::vector<std::string> adviseOnBars(const StrutGrid& grid, const MaterialRequest& material) {
  std::vector<std::string> notices;
  if (material.model == Model::paper) {
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
  const double shortest = shortestLateralRest(grid);
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
