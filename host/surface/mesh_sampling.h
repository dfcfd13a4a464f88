#pragma once
#include "surface/mesh_ray_caster.h"

namespace morphgrid {

/// How rays sampled a mesh, for pictures.
struct MeshSampling {
  TriangleMesh mesh;
  RayHits hits;
};

}  // namespace morphgrid
