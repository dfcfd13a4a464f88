#pragma once
#include <Eigen/Core>
#include <optional>

namespace morphgrid {

/// The inverse of a coarsest level's matrix, made positive definite: rigid motions of all points
/// get the mean diagonal as stiffness, unless `isHeld` says that they have some; motions of a point
/// that nothing holds that of their components, or 1.
/// matrix: 6 n square, symmetric, (t, w) of one point after the other, t about its centre; points
/// in rows, each of which is coupled with itself and its neighbours only; centres: 3 x n. Throws
/// DeviceError when the matrix is not finite.
Eigen::MatrixXd computeCoarsestInverse(const Eigen::MatrixXd& matrix,
                                       const Eigen::Matrix3Xd& centres, Eigen::Index pointsPerRow,
                                       bool isHeld = false);

/// The inverse of a symmetric, block tridiagonal matrix, in time that grows with its size squared
/// times its blocks'; nothing when it is not positive definite. blockSize divides the size.
std::optional<Eigen::MatrixXd> invertBlockTridiagonal(const Eigen::MatrixXd& matrix,
                                                      Eigen::Index blockSize);

/// The six rigid motions of the points, orthonormalised: 6 n x 6.
Eigen::MatrixXd orthonormalRigidMotions(const Eigen::Matrix3Xd& centres);

}  // namespace morphgrid
