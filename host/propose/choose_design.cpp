#include "propose/choose_design.h"

#include <algorithm>

#include "design/curvature_cutoff.h"

namespace morphgrid {
namespace {

constexpr int kLayers = 3;
// Of a strut's length. Bars are a fifth of it high.
constexpr std::array kSpacings = {0.35, 0.3, 0.25};
constexpr double kLeastSpacing = 0.22;
constexpr double kMostPlaces =
    0.95;  // A cutoff that leaves fewer as they are means a rough surface.
constexpr int kCorrections = 10;
constexpr int kOptimiseSteps = 20;

double strutLength(const SurfaceSurvey& survey, const DesignRequest& design) {
  return std::max(survey.longestIsolineU, survey.longestIsolineV) / design.nodesLong;
}

}  // namespace

DesignRequest chooseDesign(const SurfaceSurvey& survey, const ProposalRequest& request,
                           NetKind net) {
  DesignRequest design;
  design.layers = kLayers;
  design.nodesLong = request.nodesLong;
  design.maxShrinkage = request.shrink.most;
  design.net = net;
  for (const double share : kSpacings) {
    design.layerSpacing = share * strutLength(survey, design);
    design.curvatureCutoff = suggestCutoff(survey, design).value_or(0.01);
    if (design.curvatureCutoff >= kMostPlaces) break;
  }
  if (request.isPapers) {
    design.reference = net == NetKind::isoline ? Reference::convex : Reference::middle;
    return design;
  }
  design.layout = Layout::conformal;
  design.reference = Reference::middle;
  design.compensateRounds = kCorrections;
  design.optimiseSteps = kOptimiseSteps;
  design.enforceShrinkage = true;
  return design;
}

bool looksFaceted(const SurfaceSurvey& survey) {
  constexpr double kFlat = 0.02;     // Of the curvature at creases.
  constexpr double kTurning = 0.05;  // rad over the whole: less is a plane.
  constexpr double kSharp = 0.4;  // rad in a hundredth of the whole: that is an edge, to be kept.
  const double length = std::max(survey.longestIsolineU, survey.longestIsolineV);
  const double creases = curvatureAtCutoff(survey, 0.95) * length;
  return creases > kTurning && creases < 100 * kSharp &&
         curvatureAtCutoff(survey, 0.5) * length < kFlat * creases;
}

std::optional<double> fittingSpacing(const DesignTrial& trial, const SurfaceSurvey& survey,
                                     const DesignRequest& design) {
  constexpr double kSpared = 0.9;  // What the sheet's scale takes of the range.
  const double fitting = kSpared * trial.sheet.fittingLayerSpacing;
  if (fitting >= design.layerSpacing) return std::nullopt;
  const double least = kLeastSpacing * strutLength(survey, design);
  return fitting >= least ? std::optional(fitting) : std::nullopt;
}

MaterialRequest chooseMaterial(const ProposalRequest& request) {
  MaterialRequest material;
  material.model = request.isPapers ? Model::paper : Model::frame;
  material.leastShrinkage = request.isPapers ? 0 : request.shrink.least;
  return material;
}

}  // namespace morphgrid
