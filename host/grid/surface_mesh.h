#pragma once
#include <Eigen/Core>

namespace morphgrid {

/// A triangle mesh over a lattice of points.
struct SurfaceMesh {
  Eigen::Matrix3Xd vertices;
  Eigen::Matrix3Xd normals;    ///< Unit length, one per vertex.
  Eigen::Matrix3Xi triangles;  ///< Vertex indices, counter-clockwise about the normal.
};

/// Triangulates a lattice of countU x countV points (index j countU + i), with `refine` x `refine`
/// cells per lattice cell on the Catmull-Rom surface through the points; refine >= 1.
SurfaceMesh tessellate(int countU, int countV, const Eigen::Matrix3Xd& points, int refine);

}  // namespace morphgrid
