#pragma once
#include "surface/noted_mesh.h"

namespace morphgrid {

/// Rounds of Loop subdivision (CGAL), each of four triangles to one; boundaries stay boundaries.
/// Vertices that joinVertices() takes for one are joined first, triangles without area of their own
/// dropped, the others turned to agree with their neighbours. Where more than two meet at an edge,
/// the mesh is cut into sheets, with a notice: each goes on where its triangles share other edges.
/// rounds >= 0; none leave the mesh as it is. Throws InputError, without a place, when a mesh
/// without such edges cannot be oriented, or the result would exceed kMostSubdividedTriangles.
NotedMesh subdivideLoop(const TriangleMesh& mesh, int rounds);

/// About 1 GB while CGAL works at it.
inline constexpr int kMostSubdividedTriangles = 10'000'000;

}  // namespace morphgrid
