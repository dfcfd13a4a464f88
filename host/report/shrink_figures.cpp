#include "report/shrink_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "grid/strain.h"

namespace morphgrid {
namespace {

constexpr double kTolerance = 1e-6;  // A strut designed to the limit is not over it.

void add(ShrinkCounts& counts, double shrink, const ShrinkRange& range) {
  counts.largestPercent = std::max(counts.largestPercent, 100 * shrink);
  counts.largestGrowthPercent = std::max(counts.largestGrowthPercent, -100 * shrink);
  counts.strutsGrowing += shrink < -kTolerance ? 1 : 0;
  counts.strutsUnderLeast += shrink < range.least - kTolerance ? 1 : 0;
  if (shrink > range.most + kTolerance) {
    ++counts.strutsOverLimit;
  } else if (shrink >= range.most - kTolerance) {
    ++counts.strutsAtLimit;
  }
}

}  // namespace

ShrinkFigures computeShrink(const StrutGrid& stacked, const ShrinkBounds& bounds) {
  const StrutValues shrinks = computeShrinks(stacked);
  ShrinkFigures figures;
  figures.layers.resize(stacked.shape.layers);
  forEachLateralStrut(stacked.shape, [&](const Strut& strut) {
    const ShrinkRange range = bounds.at(lengthAt(stacked.positions, strut));
    add(figures, valueAt(shrinks, strut), range);
    add(figures.layers[strut.layer], valueAt(shrinks, strut), range);
  });
  return figures;
}

StrainFigures computeStrain(const StrutGrid& grid, const Eigen::Matrix3Xd& positions,
                            const std::optional<double>& limit) {
  StrainFigures figures;
  const double count = grid.shape.lateralStrutCount();
  forEachLateralStrut(grid.shape, [&](const Strut& strut) {
    const double strain = std::abs(strainAt(grid, positions, strut));
    figures.largestPercent = std::max(figures.largestPercent, 100 * strain);
    figures.meanPercent += 100 * strain / count;
    figures.strutsOverLimit += limit && strain > *limit + kTolerance ? 1 : 0;
  });
  return figures;
}

std::vector<std::string> adviseOn(const StrainFigures& strain, double limit) {
  if (strain.strutsOverLimit == 0) {
    return {};
  }
  return {fmt::format(
      "{} of the lateral struts are strained by more than design.max_strain = {:g} %, by up to "
      "{:.1f} %: raise design.optimise, lower grid.layer_spacing, or take a surface that curves "
      "less",
      strain.strutsOverLimit, 100 * limit, strain.largestPercent)};
}

std::vector<std::string> adviseOn(const ShrinkFigures& shrink, const ShrinkRange& range) {
  std::vector<std::string> advice;
  if (shrink.strutsOverLimit > 0) {
    advice.push_back(fmt::format(
        "{} of the struts must shrink by more than grid.max_shrinkage = {:g} %, by up to {:.1f} %: "
        "use a smaller grid.layer_spacing or grid.curvature_cutoff, or a material that shrinks "
        "more",
        shrink.strutsOverLimit, 100 * range.most, shrink.largestPercent));
  }
  if (shrink.largestGrowthPercent > 100 * std::max(0.0, -range.least + kTolerance)) {
    // The rest lengths stay: a larger sheet only adds to what every strut has to lose.
    const double larger = shrink.largestGrowthPercent / 100;
    const double largestShrink = 1 - (1 - shrink.largestPercent / 100) / (1 + larger);
    advice.push_back(
        fmt::format("{} of the struts must grow, by up to {:.1f} %, which no shrinking material "
                    "does: print the sheet that much larger; the largest shrink is then {:.1f} %{}",
                    shrink.strutsGrowing, 100 * larger, 100 * largestShrink,
                    largestShrink > range.most
                        ? fmt::format(", more than the material's {:g} %", 100 * range.most)
                        : ""));
  }
  if (range.least != 0 && shrink.strutsUnderLeast > 0) {
    advice.push_back(fmt::format(
        "{} of the struts shrink by less than material.least_shrinkage = {:g} %: lay the sheet out "
        "with design.layout = \"conformal\" or keep to it with design.enforce_shrinkage",
        shrink.strutsUnderLeast, 100 * range.least));
  }
  return advice;
}

}  // namespace morphgrid
