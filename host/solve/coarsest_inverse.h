#pragma once
#include <Eigen/Core>

namespace morphgrid {

/// The inverse of a coarsest level's matrix, made positive definite: rigid motions of all points
/// get the mean diagonal as stiffness, motions of a point that nothing holds that of their
/// components, or 1.
/// matrix: 6 n square, symmetric, (t, w) of one point after the other, t about its centre;
/// centres: 3 x n. Throws DeviceError when the matrix is not finite.
Eigen::MatrixXd computeCoarsestInverse(const Eigen::MatrixXd& matrix,
                                       const Eigen::Matrix3Xd& centres);

/// The six rigid motions of the points, orthonormalised: 6 n x 6.
Eigen::MatrixXd orthonormalRigidMotions(const Eigen::Matrix3Xd& centres);

}  // namespace morphgrid
