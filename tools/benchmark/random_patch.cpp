#include "benchmark/random_patch.h"

#include <algorithm>
#include <random>

namespace morphgrid {

BezierPatch randomPatch(unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> share(-1, 1);
  BezierPatch::ControlPoints points;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      const double x = 5 * i + share(random);
      const double y = 5 * j + share(random);
      points[j][i] = {x, y, 3 * share(random)};
    }
  }
  return BezierPatch(points);
}

DesignRequest requestForRandomPatch(const SurfaceSurvey& survey) {
  constexpr int kNodes = 24;
  const double spacing = std::max(survey.longestIsolineU, survey.longestIsolineV) / kNodes;
  return {.layerSpacing = 0.35 * spacing, .nodesLong = kNodes};
}

}  // namespace morphgrid
