#pragma once
#include "surface/triangle_mesh.h"

namespace morphgrid {

/// Two vertices nearer than this share of the mesh's largest extent differ by rounding alone: a
/// modeller wrote one twice.
inline constexpr double kRoundingOfVertices = 1e-9;

/// The vertices that triangles use, those joined, in each coordinate, that are that near each
/// other. Triangles stay as many; some may have the same corner twice.
TriangleMesh joinVertices(const TriangleMesh& mesh);

}  // namespace morphgrid
