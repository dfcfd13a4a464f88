#pragma once
#include <Eigen/Core>
#include <optional>
#include <vector>

namespace morphgrid {

/// The inverse of a coarsest level's matrix, made positive definite: rigid motions of all points
/// that are free (see freeMotions()) get the mean diagonal as stiffness, motions of a point that
/// nothing holds that of their components, or 1.
/// matrix: 6 n square, symmetric, (t, w) of one point after the other, t about its centre; points
/// in rows, each of which is coupled with itself and its neighbours only; centres: 3 x n. Throws
/// DeviceError when the matrix is not finite.
Eigen::MatrixXd computeCoarsestInverse(const Eigen::MatrixXd& matrix,
                                       const Eigen::Matrix3Xd& centres, Eigen::Index pointsPerRow,
                                       const std::vector<int>& free = {0, 1, 2, 3, 4, 5});

/// The inverse of a symmetric, block tridiagonal matrix, in time that grows with its size squared
/// times its blocks'; nothing when it is not positive definite. blockSize divides the size.
std::optional<Eigen::MatrixXd> invertBlockTridiagonal(const Eigen::MatrixXd& matrix,
                                                      Eigen::Index blockSize);

/// Rigid motions of the points, as freeMotions() counts them, orthonormalised: 6 n x
/// motions.size().
Eigen::MatrixXd orthonormalRigidMotions(const Eigen::Matrix3Xd& centres,
                                        const std::vector<int>& motions = {0, 1, 2, 3, 4, 5});

}  // namespace morphgrid
