#pragma once
#include "grid/strut_grid.h"

namespace morphgrid {

/// The Gauss-Newton Hessian of a grid at its positions, 3 vertexCount square, in double precision,
/// lengths in units of the spacing: 2 c J^T J of every strut's length excess, with what its tension
/// adds sideways, and 2 w J^T J of every corner's residual s sqrt(2 / (T + D)). Corners are
/// differentiated by central differences: nothing is shared with the shaders.
Eigen::MatrixXd denseHessian(const StrutGrid& grid);

/// The exact Hessian of StrutEnergy at the grid's positions, 3 vertexCount square, by differences
/// of its gradient.
Eigen::MatrixXd denseExactHessian(const StrutGrid& grid);

/// The Laplacian of the grid's struts, each with weight 1, times the unit matrix of 3 x 3.
Eigen::MatrixXd denseLaplacian(const GridShape& shape);

/// The blocks of 3 x 3 on the diagonal; zero elsewhere.
Eigen::MatrixXd diagonalBlocks(const Eigen::MatrixXd& matrix);

/// The same with each block inverted; rows and columns that are zero stay zero.
Eigen::MatrixXd invertedBlocks(const Eigen::MatrixXd& blocks);

}  // namespace morphgrid
