#pragma once
#include <Eigen/Core>

#include "grid/strut_grid.h"

namespace morphgrid {

/// Struts as closed straight prisms, in the order of forEachStrut().
constexpr int kTubeMeshSides = 6;
constexpr int kTubeMeshVertices = 2 * kTubeMeshSides;
constexpr int kTubeMeshTriangles = 2 * kTubeMeshSides + 2 * (kTubeMeshSides - 2);
/// Of the grid's spacing; springs have no thickness of their own.
constexpr double kTubeRadius = 0.03;

/// 3 x (kTubeMeshVertices strutCount), in the scene's unit of length: a hexagon at either end. It
/// is turned from the strut as printed by the smallest rotation, so that it hardly turns about its
/// strut while the grid morphs. positions: grid.shape.vertexCount() columns.
Eigen::Matrix3Xd tubeVertices(const StrutGrid& grid, const Eigen::Matrix3Xd& positions);

/// 3 x (kTubeMeshTriangles strutCount): indices of these, counter-clockwise from outside.
Eigen::Matrix3Xi tubeTriangles(const GridShape& shape);

}  // namespace morphgrid
