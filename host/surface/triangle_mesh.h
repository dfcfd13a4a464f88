#pragma once
#include <Eigen/Geometry>

namespace morphgrid {

struct TriangleMesh {
  Eigen::Matrix3Xd vertices;   ///< 3 x n, finite.
  Eigen::Matrix3Xi triangles;  ///< 3 x m of vertex indices, m >= 1.
};

/// The box of the vertices that triangles use.
Eigen::AlignedBox3d boundingBox(const TriangleMesh& mesh);

/// The mesh with every vertex moved.
TriangleMesh transformed(const Eigen::Affine3d& worldFromMesh, TriangleMesh mesh);

}  // namespace morphgrid
