#pragma once
#include "surface/triangle_mesh.h"

namespace morphgrid {

/// Rounds of Loop subdivision (CGAL), each of four triangles to one; boundaries stay boundaries.
/// Vertices at the same place are joined first. rounds >= 0. Throws InputError when the mesh is not
/// a manifold or the result exceeds kMostSubdividedTriangles.
TriangleMesh subdivideLoop(const TriangleMesh& mesh, int rounds);

inline constexpr int kMostSubdividedTriangles = 50'000'000;

}  // namespace morphgrid
