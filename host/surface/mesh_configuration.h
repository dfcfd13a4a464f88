#pragma once
#include <filesystem>

#include "surface/triangle_mesh.h"

namespace morphgrid {

/// How a mesh becomes a target: the paper's second configuration file.
struct MeshConfiguration {
  std::filesystem::path mesh;  ///< The mesh file, relative to the configuration file resolved.
  /// The transforms of the file, in their order.
  Eigen::Affine3d worldFromMesh = Eigen::Affine3d::Identity();
  int samplesU = 100;    ///< Rays along u (y) in the first pass, 4 to 4096, both ends counted.
  int samplesV = 100;    ///< The same along v (z).
  int subdivisions = 0;  ///< Rounds of Loop subdivision before the rays, 0 to 10.

  bool operator==(const MeshConfiguration& other) const;
};

/// Reads a TOML file of `mesh`, `samples_u`, `samples_v`, `subdivisions` and an array `transforms`
/// of tables, each one of `rotate = {axis = [x, y, z], degrees = d}`, `scale = s` or `[x, y, z]` >
/// 0, `translate = [x, y, z]`, applied in that order. Throws InputError with every problem as
/// `file:line:column: ...`, one a line. A mesh file is taken as it is, without transforms.
MeshConfiguration readMeshConfiguration(const std::filesystem::path& file);

}  // namespace morphgrid
