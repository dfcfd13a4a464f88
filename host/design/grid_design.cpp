#include "design/grid_design.h"

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

/// Eq. 23 may raise the node count, but not to where one crease of the surface makes a grid that
/// nobody asked for and no machine solves.
constexpr int kMostNodesRaisedTo = 2000;

/// Which cutoff would leave the layer spacing and the nodes as asked for.
std::string cutoffAdvice(const SurfaceSurvey& survey, const DesignRequest& request) {
  const std::optional<double> cutoff = suggestCutoff(survey, request);
  if (!cutoff) {
    return "no grid.curvature_cutoff would do";
  }
  return fmt::format(
      "grid.curvature_cutoff = {:g} would do, capping curvature to {:.4g} (`morphgrid check` lists "
      "others)",
      *cutoff, curvatureAtCutoff(survey, *cutoff));
}

void requireFewEnough(const CutoffConsequence& needed, const SurfaceSurvey& survey,
                      const DesignRequest& request) {
  if (needed.fewestNodes > std::max(request.nodesLong, kMostNodesRaisedTo)) {
    const std::optional<double> cutoff = suggestCutoff(survey, request);
    throw InputError(fmt::format(
        "curvature {:.4g} needs at least {:.4g} nodes along an isoline of length {:.4g} (Eq. 23); "
        "nodes are raised to at most {}: lower grid.curvature_cutoff{}, ask for as many in "
        "grid.nodes_long, or smooth the surface",
        needed.curvatureLimit, needed.fewestNodes,
        std::max(survey.longestIsolineU, survey.longestIsolineV), kMostNodesRaisedTo,
        cutoff ? fmt::format(" to {:g}", *cutoff) : ""));
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

/// Every strut needs a length, or it cannot be printed.
void requireLengths(const LateralField<double>& lengths, double longest) {
  const auto require = [&](double length, const char* direction, int i, int j) {
    if (!(length > 1e-9 * longest)) {
      throw InputError(
          fmt::format("the {} strut at node ({}, {}) has no length ({:.3g}): the surface is "
                      "collapsed there; move "
                      "the control points that coincide apart",
                      direction, i, j, length));
    }
  };
  for (int j = 0; j <= lengths.nodesV(); ++j) {
    for (int i = 0; i < lengths.nodesU(); ++i) {
      require(lengths.u(i, j), "u", i, j);
    }
  }
  for (int j = 0; j < lengths.nodesV(); ++j) {
    for (int i = 0; i <= lengths.nodesU(); ++i) {
      require(lengths.v(i, j), "v", i, j);
    }
  }
}

double largest(const LateralField<double>& field) {
  return std::max(*std::max_element(field.allU().begin(), field.allU().end()),
                  *std::max_element(field.allV().begin(), field.allV().end()));
}

/// Eq. 24, with the sine clamped; counts the clamped struts.
double bendAngle(double length, double curvature, int& clamped) {
  const double sine = length * curvature / 2;
  if (std::abs(sine) > 1) {
    ++clamped;
  }
  return 2 * std::asin(std::clamp(sine, -1.0, 1.0));
}

}  // namespace

GridSize chooseGridSize(const SurfaceSurvey& survey, const DesignRequest& request) {
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
  const bool uIsLonger = survey.longestIsolineU >= survey.longestIsolineV;
  const double longer = std::max(survey.longestIsolineU, survey.longestIsolineV);
  const double aspect = longer / std::min(survey.longestIsolineU, survey.longestIsolineV);
  size.fewestNodes = static_cast<int>(needed.fewestNodes);
  const int nodesLong = std::max(request.nodesLong, size.fewestNodes);
  const int nodesShort = shorterNodes(nodesLong, aspect);
  size.nodesU = uIsLonger ? nodesLong : nodesShort;
  size.nodesV = uIsLonger ? nodesShort : nodesLong;
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

GridDesign designGrid(const SurfaceMeasurement& measurement, const GridSize& size, int layers) {
  const int nodesU = measurement.nodesU;
  const int nodesV = measurement.nodesV;
  GridDesign design{nodesU,
                    nodesV,
                    layers,
                    size.layerSpacing,
                    largest(measurement.chords),
                    measurement.chords,
                    LateralField<double>(nodesU, nodesV),
                    {}};
  requireLengths(design.lengths, design.spacing);
  int clamped = 0;
  for (int j = 0; j <= nodesV; ++j) {
    for (int i = 0; i < nodesU; ++i) {
      design.bendAngles.u(i, j) =
          bendAngle(measurement.chords.u(i, j), measurement.curvatures.u(i, j), clamped);
    }
  }
  for (int j = 0; j < nodesV; ++j) {
    for (int i = 0; i <= nodesU; ++i) {
      design.bendAngles.v(i, j) =
          bendAngle(measurement.chords.v(i, j), measurement.curvatures.v(i, j), clamped);
    }
  }
  if (clamped > 0) {
    design.notices.push_back(fmt::format(
        "{} struts are longer than the diameter of their circle of curvature; their bend angle is "
        "clamped to pi (Eq. 24)",
        clamped));
  }
  return design;
}

GridDesign designFromBendAngles(const BendAngleRequest& request) {
  const int nodesU = request.nodesU;
  const int nodesV = request.nodesV;
  GridDesign design{nodesU,
                    nodesV,
                    request.layers,
                    request.layerSpacing,
                    request.spacing,
                    LateralField<double>(nodesU, nodesV, request.spacing),
                    LateralField<double>(nodesU, nodesV),
                    {}};
  const auto ramp = [](double first, double last, int strut, int count) {
    return count > 1 ? first + (last - first) * strut / (count - 1) : 0.5 * (first + last);
  };
  for (int j = 0; j <= nodesV; ++j) {
    for (int i = 0; i < nodesU; ++i) {
      design.bendAngles.u(i, j) = ramp(request.firstThetaU, request.lastThetaU, i, nodesU);
    }
  }
  for (int j = 0; j < nodesV; ++j) {
    for (int i = 0; i <= nodesU; ++i) {
      design.bendAngles.v(i, j) = ramp(request.firstThetaV, request.lastThetaV, j, nodesV);
    }
  }
  const double shrink = largestBendShrink(design);
  if (shrink >= 1) {
    throw InputError(
        fmt::format("bend angle, layer spacing {:g} and {} layers leave a strut of length {:g} "
                    "nothing (shrinkage "
                    "{:.4g} %, must be below 100 %); lower one of them",
                    request.layerSpacing, request.layers, request.spacing, 100 * shrink));
  }
  return design;
}

double restLength(double length, double bendAngle, double layerSpacing, int layer, int layers) {
  const int fromConvexSide = bendAngle > 0 ? layer : layers - 1 - layer;
  return length - 2 * fromConvexSide * layerSpacing * std::sin(std::abs(bendAngle) / 2);
}

double largestBendShrink(const GridDesign& design) {
  double shrink = 0;
  const auto visit = [&](const std::vector<double>& lengths, const std::vector<double>& angles) {
    for (std::size_t n = 0; n < lengths.size(); ++n) {
      const double thickness = design.layerSpacing * (design.layers - 1);
      shrink = std::max(shrink, 2 * thickness * std::sin(std::abs(angles[n]) / 2) / lengths[n]);
    }
  };
  visit(design.lengths.allU(), design.bendAngles.allU());
  visit(design.lengths.allV(), design.bendAngles.allV());
  return shrink;
}

}  // namespace morphgrid
