#pragma once
#include <filesystem>

#include "grid/joint_rotations.h"
#include "grid/strut_grid.h"
#include "grid/surface_mesh.h"

namespace morphgrid {

/// Writes a binary glTF 2.0 file (.glb) of two nodes: "struts" in the colours of their strain,
/// drawn as strutShapeOf() says, and "surface", the shaded mesh. Numbers are rounded to float, seen
/// from the middle of the grid; the nodes move them to their place and turn the scene's +z into
/// glTF's up. positions: grid.shape.vertexCount() columns; rotations: of a frame's joints, none of
/// other grids. Throws InputError naming the path when a number does not fit a float, the file
/// would be beyond glTF's size, or the disk refuses.
void exportGltf(const std::filesystem::path& path, const StrutGrid& grid,
                const Eigen::Matrix3Xd& positions, const SurfaceMesh& surface,
                const JointRotations& rotations = {});

}  // namespace morphgrid
