#pragma once
#include <filesystem>
#include <optional>

#include "core/problem_list.h"
#include "surface/bezier_patch.h"
#include "surface/mesh_configuration.h"
#include "surface/mesh_ray_caster.h"

namespace morphgrid {

// What is asked of a target, with the places that messages about it name. Equal requests have the
// same target, as long as their files stay.

struct PatchRequest {
  std::filesystem::path file;
  BezierPatch::ControlPoints controlPoints;
  Place place;  ///< Of the patch in the scene.

  bool operator==(const PatchRequest&) const = default;
};

struct MeshRequest {
  std::filesystem::path file;  ///< Of the configuration.
  MeshConfiguration configuration;
  std::optional<SamplingBox> box;
  Place boxPlace;             ///< Where the box stands in the scene, or is missing.
  double fillHoles = 0;       ///< Holes up to this width are filled; the scene's unit of length.
  double steepestSlope = 20;  ///< Steps between neighbouring rays beyond it stop the run.
  double smoothingWidth = 0;  ///< Of the curvature along isolines, in the scene's unit of length.

  bool operator==(const MeshRequest&) const = default;
};

}  // namespace morphgrid
