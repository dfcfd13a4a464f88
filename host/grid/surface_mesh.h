#pragma once
#include <Eigen/Core>

#include "grid/grid_topology.h"

namespace morphgrid {

/// A triangle mesh over a lattice of points.
struct SurfaceMesh {
  Eigen::Matrix3Xd vertices;   ///< In the unit of length of the points.
  Eigen::Matrix3Xd normals;    ///< Unit length, one per vertex.
  Eigen::Matrix3Xi triangles;  ///< Vertex indices, counter-clockwise about the normal.
};

/// Two triangles a cell of a layer of vertices, in the order of forEachCell(): 3 x 2
/// layerCellCount.
Eigen::Matrix3Xi latticeTriangles(const GridShape& layer);

/// Triangulates a layer of points with `refine` x `refine` cells per cell, refine >= 1, on the
/// Catmull-Rom surface through them. points: 3 x layerVertexCount of the shape, whose number of
/// layers does not count.
SurfaceMesh tessellate(const GridShape& shape, const Eigen::Matrix3Xd& points, int refine);

}  // namespace morphgrid
