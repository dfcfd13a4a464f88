#pragma once
#include <functional>

#include "surface/mesh_ray_caster.h"

namespace morphgrid {

using Heights = std::function<double(double y, double z)>;  ///< x above the plane of y and z.

/// The surface x = heights(y, z) over 0 .. sizeY, 0 .. sizeZ, as 2 cellsY cellsZ triangles.
TriangleMesh heightMesh(const Heights& heights, double sizeY, double sizeZ, int cellsY, int cellsZ);

/// Rays that meet the surface x = heights(y, z) over the box.
RayHits heightHits(const Heights& heights, const SamplingBox& box, int countU, int countV);

/// The ray found nothing.
void miss(RayHits& hits, int i, int j);

/// A triangle too small to be seen, at a point.
TriangleMesh speckAt(const Eigen::Vector3d& point);

}  // namespace morphgrid
