#pragma once
#include <filesystem>
#include <optional>

#include "core/problem_list.h"
#include "surface/bezier_patch.h"
#include "surface/mesh_configuration.h"
#include "surface/mesh_ray_caster.h"

namespace morphgrid {

// What a scene says about its target, with the places that messages about it name. Equal requests
// have the same target, as long as their files do not change.

struct PatchRequest {
  std::filesystem::path file;                ///< The patch file.
  BezierPatch::ControlPoints controlPoints;  ///< As the file has them.
  Place place;                               ///< Where the scene names the patch.

  bool operator==(const PatchRequest&) const = default;
};

struct MeshRequest {
  std::filesystem::path file;  ///< The mesh configuration.
  MeshConfiguration configuration;
  std::optional<SamplingBox> box;  ///< Where rays are cast; `check` may do without.
  Place boxPlace;                  ///< Where the box stands in the scene, or is missing.
  double fillHoles = 0;       ///< Holes up to this width are filled; the scene's unit of length.
  double steepestSlope = 20;  ///< Steps between neighbouring rays beyond it stop the run.
  /// Curvature is smoothed along isolines over it; in the scene's unit of length.
  double smoothingWidth = 0;

  bool operator==(const MeshRequest&) const = default;
};

}  // namespace morphgrid
