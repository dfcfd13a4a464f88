#include "design/grid_size.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "design/curvature_cutoff.h"

namespace morphgrid {
namespace {

/// Eq. 22: the shorter direction gets its share of nodes, rounded up.
int shorterNodes(int nodesLong, double aspect) {
  // A hair of tolerance: an aspect of exactly 2 must not turn 20 / 2 into 11.
  return std::max(1, static_cast<int>(std::ceil(nodesLong / aspect * (1 - 1e-12))));
}

/// Which direction is the longer one, and by how much.
struct Aspect {
  bool uIsLonger;
  double ratio;  ///< >= 1
};

Aspect aspectOf(const SurfaceSurvey& survey, const std::optional<double>& modulus) {
  if (modulus) {
    return {*modulus <= 1, std::max(*modulus, 1 / *modulus)};
  }
  const double u = survey.longestIsolineU;
  const double v = survey.longestIsolineV;
  return {u >= v, std::max(u, v) / std::min(u, v)};
}

// Eq. 23 may raise the node count, but not to where one crease of the surface makes a grid that
// nobody asked for: by this factor, and to so many.
constexpr int kMostTimesRaised = 4;
constexpr int kMostNodesRaisedTo = 2000;
// A cutoff that caps more of the surface than it leaves designs another one.
constexpr double kLeastCutoffAdvised = 0.5;

int mostNodesRaisedTo(const DesignRequest& request) {
  return std::max(request.nodesLong,
                  static_cast<int>(std::min<long>(long{kMostTimesRaised} * request.nodesLong,
                                                  kMostNodesRaisedTo)));
}

/// Which cutoff would leave the layer spacing and the nodes as asked for.
std::string cutoffAdvice(const SurfaceSurvey& survey, const DesignRequest& request) {
  const std::optional<double> cutoff = suggestCutoff(survey, request);
  if (!cutoff || *cutoff < kLeastCutoffAdvised) {
    return fmt::format(
        "no grid.curvature_cutoff of {:g} or more would do, so much of the surface curves as "
        "strongly (`morphgrid check` tells what else helps)",
        kLeastCutoffAdvised);
  }
  return fmt::format(
      "grid.curvature_cutoff = {:g} would do, capping curvature to {:.4g} (`morphgrid check` lists "
      "others and tells what else helps)",
      *cutoff, curvatureAtCutoff(survey, *cutoff));
}

void requireFewEnough(const CutoffConsequence& needed, const SurfaceSurvey& survey,
                      const DesignRequest& request) {
  if (needed.fewestNodes > mostNodesRaisedTo(request)) {
    const std::optional<double> cutoff = suggestCutoffForNodes(survey, request);
    throw InputError(fmt::format(
        "curvature {:.4g} needs at least {:.4g} nodes along an isoline of length {:.4g} (Eq. 23), "
        "{:.3g} times grid.nodes_long = {}; it is raised to {} at most: {}set grid.nodes_long = "
        "{:.0f} if you want as many, or smooth the surface (a mesh by surface.smoothing_width, or "
        "subdivisions in its configuration)",
        needed.curvatureLimit, needed.fewestNodes,
        std::max(survey.longestIsolineU, survey.longestIsolineV),
        needed.fewestNodes / request.nodesLong, request.nodesLong, mostNodesRaisedTo(request),
        cutoff && *cutoff >= kLeastCutoffAdvised
            ? fmt::format("grid.curvature_cutoff = {:g} keeps those that you asked for, ", *cutoff)
            : "",
        needed.fewestNodes));
  }
}

/// Strut counts, the largest, must fit into an int.
void requireCountable(const GridSize& size, int layers) {
  const double vertices = (size.nodesU + 1.0) * (size.nodesV + 1.0) * layers;
  const double limit = std::numeric_limits<int>::max() / 3.0;
  if (vertices > limit) {
    throw InputError(
        fmt::format("{} x {} nodes in {} layers are {:.3g} vertices, at most {:.3g} can be "
                    "numbered; ask for fewer nodes or layers",
                    size.nodesU, size.nodesV, layers, vertices, limit));
  }
}

}  // namespace

GridSize chooseGridSize(const SurfaceSurvey& survey, const DesignRequest& request,
                        std::optional<double> modulus) {
  const CutoffConsequence needed = consequenceOf(request.curvatureCutoff, survey, request);
  GridSize size{};
  size.curvatureLimit = needed.curvatureLimit;
  if (size.curvatureLimit < survey.largestCurvature()) {
    size.notices.push_back(fmt::format(
        "curvature is capped to {:.4g}, the cutoff p = {:g} of its samples (largest: {:.4g})",
        size.curvatureLimit, request.curvatureCutoff, survey.largestCurvature()));
  }

  size.layerSpacingLimit = needed.layerSpacingLimit;
  size.layerSpacing = std::min(request.layerSpacing, size.layerSpacingLimit);
  if (size.layerSpacing < request.layerSpacing) {
    size.notices.push_back(
        fmt::format("layer spacing {:g} is clamped to {:.4g}: curvature {:.4g} with {} layers "
                    "would need more than {:g} % shrinkage (Eq. 21); {}",
                    request.layerSpacing, size.layerSpacing, size.curvatureLimit, request.layers,
                    100 * request.maxShrinkage, cutoffAdvice(survey, request)));
  }

  requireFewEnough(needed, survey, request);
  const Aspect aspect = aspectOf(survey, modulus);
  size.fewestNodes = static_cast<int>(needed.fewestNodes);
  const int nodesLong = std::max(request.nodesLong, size.fewestNodes);
  const int nodesShort = modulus
                             ? std::max(1, static_cast<int>(std::lround(nodesLong / aspect.ratio)))
                             : shorterNodes(nodesLong, aspect.ratio);
  size.nodesU = aspect.uIsLonger ? nodesLong : nodesShort;
  size.nodesV = aspect.uIsLonger ? nodesShort : nodesLong;
  requireCountable(size, request.layers);
  if (nodesLong > request.nodesLong) {
    size.notices.push_back(fmt::format(
        "{} nodes on the long edge are raised to {} ({} x {}): a strut may span at most a half "
        "circle of radius {:.4g} (Eq. 23); {}",
        request.nodesLong, nodesLong, size.nodesU, size.nodesV, 1 / size.curvatureLimit,
        cutoffAdvice(survey, request)));
  }
  return size;
}

}  // namespace morphgrid
