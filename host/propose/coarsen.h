#pragma once
#include "surface/triangle_mesh.h"

namespace morphgrid {

/// The mesh itself or, of one with many triangles, one with fewer that looks like it from afar:
/// vertices within the same cube of a two-hundredth of its main extent become one, triangles that
/// collapse are dropped. What is closed stays closed.
TriangleMesh coarsened(const TriangleMesh& mesh);

}  // namespace morphgrid
