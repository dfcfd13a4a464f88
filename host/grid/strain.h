#pragma once
#include <vector>

#include "grid/strut_grid.h"

namespace morphgrid {

/// (|e| - L)/L of a strut, > 0 where stretched. positions: grid.shape.vertexCount() columns, in the
/// unit of the rest lengths.
double strainAt(const StrutGrid& grid, const Eigen::Matrix3Xd& positions, const Strut& strut);

/// (|e| - L)/L of every strut, in the order of forEachStrut(); > 0 where stretched.
/// positions: grid.shape.vertexCount() columns, in the unit of the rest lengths.
std::vector<double> strains(const StrutGrid& grid, const Eigen::Matrix3Xd& positions);

}  // namespace morphgrid
