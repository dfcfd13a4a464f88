#pragma once
#include <filesystem>

#include "grid/strut_grid.h"

namespace morphgrid {

/// Writes a VTK unstructured grid (.vtu): a line per strut, in the order of forEachStrut(), with
/// the cell arrays strain, rest_length, shrink (computeShrinks(); double), layer and direction
/// (int; 0 u, 1 v, 2 w). positions: grid.shape.vertexCount() columns. Throws InputError naming the
/// path when the disk refuses.
void exportVtu(const std::filesystem::path& path, const StrutGrid& grid,
               const Eigen::Matrix3Xd& positions);

}  // namespace morphgrid
