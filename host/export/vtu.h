#pragma once
#include <filesystem>

#include "grid/joint_rotations.h"
#include "grid/strut_grid.h"

namespace morphgrid {

/// Writes a VTK unstructured grid (.vtu): a line per strut, in the order of forEachStrut(), with
/// the cell arrays strain, rest_length, shrink (computeShrinks(); double), layer and direction
/// (int; 0 u, 1 v, 2 w); of a frame also those of BarState: axial_energy, bending_energy,
/// shear_energy, twist_energy, bending_strain, joint_rotation (double). positions:
/// grid.shape.vertexCount() columns; rotations: of a frame's joints, none of other grids. Throws
/// InputError naming the path when the disk refuses.
void exportVtu(const std::filesystem::path& path, const StrutGrid& grid,
               const Eigen::Matrix3Xd& positions, const JointRotations& rotations = {});

}  // namespace morphgrid
