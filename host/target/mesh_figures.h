#pragma once
#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "surface/mesh_ray_caster.h"

namespace morphgrid {

/// How rays sampled a mesh.
struct MeshFigures {
  std::string file;
  int triangles = 0;
  int rays = 0;            ///< Of both passes.
  int missed = 0;          ///< Of those; filled where the run went on.
  double largestJump = 0;  ///< Steepest step between neighbouring rays: |dx| over their distance.
  double secondsBuild = 0;
  double secondsRays = 0;
  Eigen::AlignedBox3d extent;               ///< Of the transformed mesh.
  std::optional<SamplingBox> suggestedBox;  ///< One without holes, where there is one.
};

}  // namespace morphgrid
