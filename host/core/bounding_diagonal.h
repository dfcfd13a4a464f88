#pragma once
#include <Eigen/Core>

namespace morphgrid {

/// The diagonal of the axis-parallel bounding box of points, 3 x n with n >= 1, in their unit of
/// length.
double boundingDiagonal(const Eigen::Matrix3Xd& points);

}  // namespace morphgrid
