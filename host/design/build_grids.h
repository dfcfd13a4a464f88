#pragma once
#include "design/grid_design.h"
#include "grid/strut_grid.h"

namespace morphgrid {

/// c of `w c (|e| - L)^2`.
enum class Scaling {
  normalised,  ///< c = 1: the answer does not depend on the unit of length.
  shapeop,     ///< c = L_initial / L^2, as the paper's library; depends on the unit of length.
};

/// What a scene weighs its constraints with.
struct Weights {
  double lateral = 5;
  double vertical = 40;
  double angle = 1;
};

/// One flat layer of square cells whose struts rest at L0 (paper, in-plane stage).
StrutGrid inPlaneGrid(const GridDesign& design, const Weights& weights, Scaling scaling);

/// The printed layer copied `layers` times at distance tau, with the rest lengths of the design.
/// printedLayer: (nodesU+1)(nodesV+1) columns, in the plane.
StrutGrid stackedGrid(const GridDesign& design, const Weights& weights, Scaling scaling,
                      const Eigen::Matrix3Xd& printedLayer);

}  // namespace morphgrid
