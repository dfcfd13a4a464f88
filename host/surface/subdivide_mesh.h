#pragma once
#include "surface/triangle_mesh.h"

namespace morphgrid {

/// Rounds of Loop subdivision (CGAL), each of four triangles to one; boundaries stay boundaries.
/// Vertices at the same place are joined first, triangles without area of their own dropped, the
/// others turned to agree with their neighbours. rounds >= 0; none leave the mesh as it is. Throws
/// InputError, without a place, when the mesh is not an orientable manifold or the result would
/// exceed kMostSubdividedTriangles.
TriangleMesh subdivideLoop(const TriangleMesh& mesh, int rounds);

/// About 1 GB while CGAL works at it.
inline constexpr int kMostSubdividedTriangles = 10'000'000;

}  // namespace morphgrid
