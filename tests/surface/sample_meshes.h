#pragma once
#include <functional>

#include "surface/mesh_ray_caster.h"

namespace morphgrid {

/// x = height(y, z) over a box, in cellsU x cellsV pairs of triangles.
TriangleMesh heightField(const SamplingBox& box, int cellsU, int cellsV,
                         const std::function<double(double, double)>& height);

/// A sphere around the origin whose poles lie on the x axis. Vertices at the seam, z = 0 < y, and
/// at the poles are doubled.
TriangleMesh sphere(double radius, int meridians, int parallels);

/// The apex at the origin, its rim of `sides` corners at x = height and distance 1 from the x axis,
/// the first on the y axis.
TriangleMesh pyramidFan(int sides, double height);

/// The triangles of one mesh and of another, in one.
TriangleMesh joined(const TriangleMesh& first, const TriangleMesh& second);

}  // namespace morphgrid
