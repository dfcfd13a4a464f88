#pragma once
#include "surface/triangle_mesh.h"

namespace morphgrid {

/// The bounding box of the part of a mesh that has the most area, and of what lies near it: debris
/// that is farther away than half of the part's size does not count.
Eigen::AlignedBox3d mainExtent(const TriangleMesh& mesh);

/// Of all triangles.
double surfaceArea(const TriangleMesh& mesh);

}  // namespace morphgrid
