#pragma once
#include <Eigen/Geometry>
#include <optional>
#include <string>

#include "surface/mesh_ray_caster.h"

namespace morphgrid {

/// How rays sampled a mesh.
struct MeshFigures {
  std::string file;
  int triangles = 0;           ///< After subdivision.
  int rays = 0;                ///< Rays cast in both passes.
  int missed = 0;              ///< Rays that hit nothing; where the run went on, they were filled.
  double largestJump = 0;      ///< Steepest step between neighbouring rays: abs(dx) / distance.
  double secondsBuild = 0;     ///< Wall time of building the hierarchy for the rays.
  double secondsRays = 0;      ///< Wall time of casting.
  Eigen::AlignedBox3d extent;  ///< Bounding box of the transformed mesh.
  std::optional<SamplingBox> suggestedBox;  ///< One without holes, where there is one.
};

}  // namespace morphgrid
