#pragma once
#include <Eigen/Core>
#include <vector>

namespace morphgrid {

/// The triangles that meet another one with which they share no vertex (Embree finds candidates,
/// CGAL's exact predicate decides), in ascending order. Triangles without area meet nothing.
/// vertices 3 x n, finite; triangles 3 x m of vertex indices.
std::vector<int> findSelfIntersections(const Eigen::Matrix3Xd& vertices,
                                       const Eigen::Matrix3Xi& triangles);

}  // namespace morphgrid
