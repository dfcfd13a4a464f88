#pragma once
#include <Eigen/Core>

#include "grid/grid_topology.h"

namespace morphgrid {

/// A triangle mesh over a lattice of points.
struct SurfaceMesh {
  Eigen::Matrix3Xd vertices;
  Eigen::Matrix3Xd normals;    ///< Unit length, one per vertex.
  Eigen::Matrix3Xi triangles;  ///< Vertex indices, counter-clockwise about the normal.
};

/// Triangulates a layer of points, of whose shape the layers do not count (one column a vertex),
/// with `refine` x `refine` cells per cell on the Catmull-Rom surface through the points; refine
/// >= 1.
SurfaceMesh tessellate(const GridShape& shape, const Eigen::Matrix3Xd& points, int refine);

}  // namespace morphgrid
