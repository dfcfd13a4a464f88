#include "report/shrink_figures.h"

#include <fmt/format.h>

#include <algorithm>

#include "grid/shrink.h"

namespace morphgrid {
namespace {

constexpr double kTolerance = 1e-6;  // A strut designed to the limit is not over it.

void add(ShrinkCounts& counts, double shrink, double limit) {
  counts.largestPercent = std::max(counts.largestPercent, 100 * shrink);
  counts.largestGrowthPercent = std::max(counts.largestGrowthPercent, -100 * shrink);
  counts.strutsGrowing += shrink < -kTolerance ? 1 : 0;
  if (shrink > limit + kTolerance) {
    ++counts.strutsOverLimit;
  } else if (shrink >= limit - kTolerance) {
    ++counts.strutsAtLimit;
  }
}

}  // namespace

ShrinkFigures computeShrink(const StrutGrid& stacked, double maxShrinkage) {
  const StrutValues shrinks = computeShrinks(stacked);
  ShrinkFigures figures;
  figures.layers.resize(stacked.shape.layers);
  forEachLateralStrut(stacked.shape, [&](const Strut& strut) {
    add(figures, valueAt(shrinks, strut), maxShrinkage);
    add(figures.layers[strut.layer], valueAt(shrinks, strut), maxShrinkage);
  });
  return figures;
}

std::vector<std::string> adviseOn(const ShrinkFigures& shrink, double maxShrinkage) {
  std::vector<std::string> advice;
  if (shrink.strutsOverLimit > 0) {
    advice.push_back(fmt::format(
        "{} of the struts must shrink by more than grid.max_shrinkage = {:g} %, by up to {:.1f} %: "
        "use a smaller grid.layer_spacing or grid.curvature_cutoff, or a material that shrinks "
        "more",
        shrink.strutsOverLimit, 100 * maxShrinkage, shrink.largestPercent));
  }
  if (shrink.strutsGrowing > 0) {
    // The rest lengths stay: a larger sheet only adds to what every strut has to lose.
    const double larger = shrink.largestGrowthPercent / 100;
    const double largestShrink = 1 - (1 - shrink.largestPercent / 100) / (1 + larger);
    advice.push_back(
        fmt::format("{} of the struts must grow, by up to {:.1f} %, which no shrinking material "
                    "does: print the "
                    "sheet that much larger; the largest shrink is then {:.1f} %",
                    shrink.strutsGrowing, 100 * larger, 100 * largestShrink));
  }
  return advice;
}

}  // namespace morphgrid
