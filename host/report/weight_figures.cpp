#include "report/weight_figures.h"

#include <fmt/format.h>

namespace morphgrid {
namespace {

// Of the diagonal: from there on weight is what one sees. A judgement, not measured.
constexpr double kDominant = 0.05;

}  // namespace

std::vector<std::string> adviseOn(const WeightFigures& weight, double diagonal) {
  if (weight.sag.value_or(0) <= kDominant * diagonal) {
    return {};
  }
  return {fmt::format(
      "the grid sags by {:.3g} under its weight, {:.0f} % of its diagonal: raise "
      "grid.layer_spacing, material.bar_height or the number of material.supports, or take a "
      "fluid that carries more of it (material.fluid_density)",
      *weight.sag, 100 * *weight.sag / diagonal)};
}

}  // namespace morphgrid
