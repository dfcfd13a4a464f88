#pragma once
#include <filesystem>
#include <optional>

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

/// The same of the grid as it is printed, grid.positions, with the point arrays `morphed`, where
/// its vertices end, and `target`, where those of the middle layer (the middle two of an even
/// number) should end, else NaN; both 3 doubles. Cell arrays: rest_length, printed_length (double),
/// layer and direction (int). morphed: 3 x vertexCount; targets: 3 x layerVertexCount.
void exportPrintedVtu(const std::filesystem::path& path, const StrutGrid& grid,
                      const Eigen::Matrix3Xd& morphed,
                      const std::optional<Eigen::Matrix3Xd>& targets);

}  // namespace morphgrid
