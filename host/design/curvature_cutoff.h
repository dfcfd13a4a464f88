#pragma once
#include <optional>
#include <vector>

#include "design/grid_size.h"

namespace morphgrid {

/// What a cutoff p would mean for the grid.
struct CutoffConsequence {
  double cutoff;             ///< p
  double curvatureLimit;     ///< |kappa| at p, 1 / length.
  double layerSpacingLimit;  ///< Eq. 21; infinite when nothing bends or there is one layer.
  double fewestNodes;        ///< Eq. 23, along the longer direction; a real number, it may be huge.
};

/// cutoff in (0, 1].
CutoffConsequence consequenceOf(double cutoff, const SurfaceSurvey& survey,
                                const DesignRequest& request);

/// For p = 0.5, 0.9, 0.95, 0.99 and 1.
std::vector<CutoffConsequence> listCutoffConsequences(const SurfaceSurvey& survey,
                                                      const DesignRequest& request);

/// The largest p, in hundredths, at which neither the layer spacing is clamped nor nodes are
/// raised; nothing when even 0.01 does not do.
std::optional<double> suggestCutoff(const SurfaceSurvey& survey, const DesignRequest& request);

/// The same where only the nodes count.
std::optional<double> suggestCutoffForNodes(const SurfaceSurvey& survey,
                                            const DesignRequest& request);

}  // namespace morphgrid
