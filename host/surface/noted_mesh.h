#pragma once
#include <string>
#include <vector>

#include "surface/triangle_mesh.h"

namespace morphgrid {

/// A mesh, and what people should know of how it came about: one line each, without a place.
struct NotedMesh {
  TriangleMesh mesh;
  std::vector<std::string> notices;
};

}  // namespace morphgrid
