#pragma once
#include <filesystem>
#include <vector>

#include "grid/joint_rotations.h"
#include "grid/strut_grid.h"
#include "grid/surface_mesh.h"

namespace morphgrid {

/// A shape that a morphing grid passes through.
struct MorphKey {
  Eigen::Matrix3Xd positions;  ///< grid.shape.vertexCount() columns.
  SurfaceMesh surface;         ///< All keys have the same triangles.
  JointRotations rotations{};  ///< Of a frame.
};

/// When the grid has the shape of which key; linear in between.
struct MorphMoment {
  double seconds;  ///< From the beginning, growing.
  int key;         ///< Index.
};

/// Writes a binary glTF 2.0 file (.glb) with an animation "morph" of the two nodes of exportGltf():
/// the first key is the shape of the meshes, each further one a morph target, and the animation
/// their weights. Struts keep the colours of their strain at the first key. keys: at least 2.
/// Throws InputError as exportGltf() does.
void exportGltfMorph(const std::filesystem::path& path, const StrutGrid& grid,
                     const std::vector<MorphKey>& keys, const std::vector<MorphMoment>& timeline);

}  // namespace morphgrid
