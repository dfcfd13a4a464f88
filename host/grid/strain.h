#pragma once
#include <vector>

#include "grid/strut_grid.h"

namespace morphgrid {

/// (|e| - L)/L of every strut, in the order of listStruts(grid.shape); > 0 where stretched.
/// positions: grid.shape.vertexCount() columns, in the unit of the rest lengths.
std::vector<double> strains(const StrutGrid& grid, const Eigen::Matrix3Xd& positions);

}  // namespace morphgrid
