#pragma once
#include <vector>

#include "grid/strut_grid.h"

namespace morphgrid {

/// A problem of fewer nodes, or heavier corners, whose equilibrium resembles that of a finer one.
struct NestedGrid {
  StrutGrid grid;
  double thickness;  ///< Distance of its layers over that of the finest grid's.
};

/// Coarser and coarser problems, the coarsest first, the grid itself last. From one to the next
/// coarser the nodes halve (rounded up), down to ten on the longer edge or to where a strut would
/// have to turn by more than 1 rad; the layers move apart by 2 (at first by sqrt(2)), as far as the
/// rest lengths allow: grids that are thin for their spacing are the hard ones. A coarse strut
/// rests at the sum of the struts that it stands for, interpolated between lines; where layers
/// differ, the difference grows with their distance, which keeps the curvature. Where corners are
/// light beside struts, the coarsest grid comes several times, at first with heavier corners.
std::vector<NestedGrid> nestGrids(const StrutGrid& finest);

/// Positions for the finer grid: the mean of all layers and the layers' offsets from it, in cubic
/// interpolation, the offsets scaled to the finer grid's thickness. positions: 3 x vertexCount of
/// coarse.grid.
Eigen::Matrix3Xd prolong(const NestedGrid& coarse, const Eigen::Matrix3Xd& positions,
                         const NestedGrid& fine);

}  // namespace morphgrid
