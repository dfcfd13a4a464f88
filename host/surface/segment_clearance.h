#pragma once
#include <Eigen/Core>

namespace morphgrid {

using Matrix2Xi = Eigen::Matrix<int, 2, Eigen::Dynamic>;

/// For every segment the distance to the closest other one with which it shares no end, where that
/// is below `reach`; infinity elsewhere. points 3 x n, finite; segments 2 x m of point indices;
/// reach > 0, in the points' unit.
Eigen::VectorXd segmentClearances(const Eigen::Matrix3Xd& points, const Matrix2Xi& segments,
                                  double reach);

}  // namespace morphgrid
