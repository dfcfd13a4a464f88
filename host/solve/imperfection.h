#pragma once
#include "grid/strut_grid.h"

namespace morphgrid {

/// `positions` (3 x vertexCount) of a grid of several layers, moved a little along smooth waves
/// that have no symmetry, all layers of a column alike: so symmetric grids buckle, where else they
/// would come to rest at a saddle of the energy. Always the same waves. One layer stays in its
/// plane.
Eigen::Matrix3Xd withImperfection(const StrutGrid& grid, Eigen::Matrix3Xd positions);

}  // namespace morphgrid
