#pragma once
#include <Eigen/Core>

namespace morphgrid {

/// The diagonal of a box around points, 3 x n with n >= 1, that turns with them: one side along
/// their axis of inertia of least spread, of the others one along an edge of their outline seen
/// along it, the edge whose box has the least diagonal. Distances to a target are given in percent
/// of that of the target's points.
double intrinsicDiagonal(const Eigen::Matrix3Xd& points);

}  // namespace morphgrid
