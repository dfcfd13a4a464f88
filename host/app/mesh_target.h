#pragma once
#include <filesystem>
#include <memory>
#include <optional>

#include "core/toml_reader.h"
#include "surface/mesh_ray_caster.h"
#include "surface/triangle_mesh.h"

namespace morphgrid {

/// A triangle mesh and how rays along +x measure it.
struct MeshTarget {
  std::filesystem::path file;  ///< The mesh file.
  TriangleMesh mesh;           ///< Transformed and subdivided, in the scene's unit of length.
  int samplesU;                ///< Rays along u (y) in the first pass.
  int samplesV;                ///< Rays along v (z) in the first pass.
  SamplingBox box;
  double fillHoles = 0;       ///< Holes up to this width are filled; the scene's unit of length.
  double steepestSlope = 20;  ///< Steps between neighbouring rays beyond it stop the run.
  double smoothingWidth = 0;  ///< Of the curvature along isolines, in the scene's unit of length.
};

/// The keys of [surface] that belong to meshes, as far as they are there.
struct MeshKeys {
  std::optional<std::filesystem::path> mesh;
  std::optional<double> uStart, vStart, uLength, vLength;
  MeshTarget settings;
};

/// The names of those keys.
inline constexpr const char* kMeshKeys[] = {"mesh",           "u_start",        "v_start",
                                            "u_length",       "v_length",       "fill_holes",
                                            "steepest_slope", "smoothing_width"};

MeshKeys readMeshKeys(TomlSection& surface);

/// Reads the mesh that the keys name. Problems go to the reader, a missing box with one to start
/// from; nothing then.
std::shared_ptr<const MeshTarget> loadMeshTarget(TomlReader& reader, TomlSection& surface,
                                                 MeshKeys keys);

}  // namespace morphgrid
