#pragma once
#include <Eigen/Core>

#include "grid/joint_rotations.h"
#include "grid/strut_grid.h"

namespace morphgrid {

/// The bars of a frame as closed prisms, in the order of forEachStrut().
constexpr int kBarMeshPieces = 4;  ///< Along it.
constexpr int kBarMeshVertices = 4 * (kBarMeshPieces + 1);
constexpr int kBarMeshTriangles = 8 * kBarMeshPieces + 4;

/// 3 x (kBarMeshVertices strutCount), in the scene's unit of length: rectangles of the sections'
/// width and height, turned as the joints at the bar's ends are, along a cubic curve that leaves
/// either joint as the joint holds the bar. Lateral bars that end at the border reach half their
/// width beyond it, which closes the joints. positions and rotations: grid.shape.vertexCount()
/// columns; the grid has bars.
Eigen::Matrix3Xd barVertices(const StrutGrid& grid, const Eigen::Matrix3Xd& positions,
                             const JointRotations& rotations);

/// 3 x (kBarMeshTriangles strutCount): indices of these, counter-clockwise from outside.
Eigen::Matrix3Xi barTriangles(const GridShape& shape);

}  // namespace morphgrid
