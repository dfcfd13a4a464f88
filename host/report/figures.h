#pragma once
#include <optional>

#include "design/grid_design.h"
#include "grid/strut_grid.h"
#include "report/distance_spread.h"
#include "surface/closest_point.h"

namespace morphgrid {

/// How far the struts and corners ended from what the design wants; percent.
struct StrutErrors {
  double l0Percent;  ///< Mean | |e| - L0 | / L0 over lateral struts of the layer that carries L0.
  double lbPercent;  ///< The same for L_b, on the layer of the concave side.
  double anglePercent;  ///< Mean over all corners of |angle - 90| / 90.
};

/// positions: 3 x vertexCount of `grid`, whose rest lengths are measured against.
StrutErrors computeStrutErrors(const GridDesign& design, const StrutGrid& grid,
                               const Eigen::Matrix3Xd& positions);

/// To the closest points of the target's surface: forgives sliding in it; percent of the diagonal.
struct ClosestDistance {
  double rmsPercent;
  double maxPercent;
  DistanceSpread spread;
};

/// Distance of the middle layer to the target after rigid alignment, in percent of the diagonal of
/// the target's bounding box.
struct TargetDistance {
  double rmsPercent;  ///< To the point of the same parameters.
  double maxPercent;
  DistanceSpread spread;
  std::optional<ClosestDistance> closest;  ///< Absent where they were not looked for.
  double diagonal = 0;  ///< What percents refer to, in the scene's unit, see intrinsicDiagonal().
  double axisParallelDiagonal = 0;  ///< Of the box along the axes, which turns with them.
};

/// middle, targets: one column per vertex of a layer, matching. closestPoints: of the target;
/// nullptr where they would take too long.
TargetDistance computeTargetDistance(const Eigen::Matrix3Xd& middle,
                                     const Eigen::Matrix3Xd& targets,
                                     const ClosestPointQuery* closestPoints);

}  // namespace morphgrid
