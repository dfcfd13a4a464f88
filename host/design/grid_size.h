#pragma once
#include <optional>
#include <string>
#include <vector>

#include "measure/net.h"
#include "measure/surface_measurement.h"

namespace morphgrid {

/// Which side of the grid has the target's shape, and so what struts rest at.
enum class Reference {
  convex,  ///< Each strut's convex side: the paper's Eqs. 24, 25.
  middle,  ///< The middle of the layers; each layer lies on the target's offset surface.
};

/// As scene files call them.
inline constexpr std::array kReferenceWords = {"convex", "middle"};

/// How the net is laid out on the flat sheet that is printed.
enum class Layout {
  inPlane,  ///< Square cells morph in their plane to the lengths of the convex sides: the paper's.
  conformal,  ///< Joints keep the angles that they have on the target, see layConformally().
};

/// As scene files call them.
inline constexpr std::array kLayoutWords = {"in_plane", "conformal"};
constexpr const char* nameOf(Layout layout) {
  return kLayoutWords[static_cast<std::size_t>(layout)];
}

/// What the user asks of a grid (paper, section 3.1).
struct DesignRequest {
  int layers = 3;                ///< >= 1
  double layerSpacing = 0;       ///< tau, in the scene's unit of length, > 0
  int nodesLong = 20;            ///< Nodes along the longer direction, >= 1
  double maxShrinkage = 0.4;     ///< Share of its printed length that a strut can lose, in (0, 1)
  double curvatureCutoff = 1.0;  ///< p, in (0, 1]: share of the |kappa| samples left uncapped
  NetKind net = NetKind::isoline;
  Reference reference = Reference::convex;
  Layout layout = Layout::inPlane;
  std::optional<double> maxStrutRatio;   ///< Longest over shortest strut, > 1
  int compensateRounds = 0;              ///< Rounds of spring-back correction, >= 0
  int optimiseSteps = 0;                 ///< Steps along the adjoint gradient, >= 0
  bool enforceShrinkage = false;         ///< Whether both honour maxShrinkage.
  std::optional<double> maxStrain;       ///< Of lateral struts at rest, > 0: both honour it.
  std::optional<double> strutThickness;  ///< As printed, in the scene's unit of length, > 0

  bool operator==(const DesignRequest&) const = default;
};

/// The size of a grid, chosen from the survey (Eqs. 21 - 23).
struct GridSize {
  int nodesU;
  int nodesV;
  double layerSpacing;
  double curvatureLimit;     ///< kappa_max after the cutoff, in 1 / length, >= 0
  double layerSpacingLimit;  ///< R maxShrinkage / (layers-1); infinite for flat surfaces or 1 layer
  int fewestNodes;           ///< Eq. 23, along the longer direction, >= 1
  std::vector<std::string> notices;  ///< What was clamped or overridden, for the user.
};

/// modulus: of a conformal map's rectangle, extent along v over that along u, > 0. Where it is
/// given it sets the ratio of the node counts, rounded, so that nodes are as square as they can be;
/// otherwise that is the ratio of the longest isolines (Eq. 22).
GridSize chooseGridSize(const SurfaceSurvey& survey, const DesignRequest& request,
                        std::optional<double> modulus = std::nullopt);

}  // namespace morphgrid
