#include "inverse/shape_error.h"

#include <cmath>

#include "core/intrinsic_diagonal.h"
#include "core/rigid_alignment.h"

namespace morphgrid {

using Eigen::Matrix3Xd;

ShapeError computeShapeError(const GridShape& shape, const Matrix3Xd& positions,
                             const Matrix3Xd& targets) {
  const Matrix3Xd middle = middleLayer(shape, positions);
  const Matrix3Xd offsets = middle - alignRigidly(targets, middle) * targets;
  const double diagonal = intrinsicDiagonal(targets);
  ShapeError error{0.5 * offsets.squaredNorm(),
                   100 / diagonal * std::sqrt(offsets.colwise().squaredNorm().mean()),
                   100 / diagonal * std::sqrt(offsets.colwise().squaredNorm().maxCoeff()),
                   Matrix3Xd::Zero(3, positions.cols())};
  // The middle layer is one layer, or the mean of two.
  layerOf(shape, error.gradient, (shape.layers - 1) / 2) += 0.5 * offsets;
  layerOf(shape, error.gradient, shape.layers / 2) += 0.5 * offsets;
  return error;
}

}  // namespace morphgrid
