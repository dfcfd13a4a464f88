#pragma once
#include <Eigen/Core>

#include "grid/strut_grid.h"

namespace morphgrid {

/// How far a grid's middle layer is from its target, after rigid alignment.
struct ShapeError {
  double objective;           ///< J = 1/2 sum |x - target|^2 over the middle layer's vertices.
  double rmsPercent;          ///< Percent of the diagonal of the targets' bounding box.
  double maxPercent;          ///< Largest distance, in the same percent.
  Eigen::Matrix3Xd gradient;  ///< dJ/dx, 3 x vertexCount; has no rigid motion in it.
};

/// positions: 3 x vertexCount; targets: 3 x layerVertexCount.
ShapeError computeShapeError(const GridShape& shape, const Eigen::Matrix3Xd& positions,
                             const Eigen::Matrix3Xd& targets);

}  // namespace morphgrid
