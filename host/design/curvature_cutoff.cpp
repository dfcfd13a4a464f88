#include "design/curvature_cutoff.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace morphgrid {
namespace {

/// Eq. 21: the layers on the concave side shrink by no more than maxShrinkage.
double layerSpacingLimit(double curvature, const DesignRequest& request) {
  if (request.layers == 1 || curvature == 0) {
    return std::numeric_limits<double>::infinity();
  }
  return request.maxShrinkage / (curvature * (request.layers - 1));
}

/// Eq. 23: a strut spans at most a half circle of the tightest radius.
double fewestNodes(double curvature, const SurfaceSurvey& survey) {
  const double longer = std::max(survey.longestIsolineU, survey.longestIsolineV);
  return std::max(1.0, std::ceil(longer * curvature / 2));
}

/// In hundredths; nothing when not even 0.01 suits.
template <typename Suits>
std::optional<double> largestCutoff(const SurfaceSurvey& survey, const DesignRequest& request,
                                    const Suits& suits) {
  for (int hundredths = 100; hundredths >= 1; --hundredths) {
    const double cutoff = hundredths / 100.0;
    if (suits(consequenceOf(cutoff, survey, request))) return cutoff;
  }
  return std::nullopt;
}

}  // namespace

CutoffConsequence consequenceOf(double cutoff, const SurfaceSurvey& survey,
                                const DesignRequest& request) {
  const double curvature = curvatureAtCutoff(survey, cutoff);
  return {cutoff, curvature, layerSpacingLimit(curvature, request), fewestNodes(curvature, survey)};
}

std::vector<CutoffConsequence> listCutoffConsequences(const SurfaceSurvey& survey,
                                                      const DesignRequest& request) {
  std::vector<CutoffConsequence> consequences;
  for (const double cutoff : {0.5, 0.9, 0.95, 0.99, 1.0}) {
    consequences.push_back(consequenceOf(cutoff, survey, request));
  }
  return consequences;
}

std::optional<double> suggestCutoff(const SurfaceSurvey& survey, const DesignRequest& request) {
  return largestCutoff(survey, request, [&](const CutoffConsequence& there) {
    return there.layerSpacingLimit >= request.layerSpacing &&
           there.fewestNodes <= request.nodesLong;
  });
}

std::optional<double> suggestCutoffForNodes(const SurfaceSurvey& survey,
                                            const DesignRequest& request) {
  return largestCutoff(survey, request, [&](const CutoffConsequence& there) {
    return there.fewestNodes <= request.nodesLong;
  });
}

}  // namespace morphgrid
