#include "solve/coarsest_inverse.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/QR>

#include "core/error.h"

namespace morphgrid {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;

/// Share of the diagonal that is added to it: rounding in single precision may have made soft
/// motions negative. More is tried where that does not suffice, but more from the start would hide
/// the softest motions of long grids.
constexpr double kLeastShift = 1e-7;
/// A point's motion counts as free when its stiffness is this share of what its components have.
constexpr double kFree = 1e-5;

using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// A point's motions that its own block does not hold: all where nothing is stiff (z in the plane),
/// turns of a straight column about itself. They get the stiffness of their components, or 1: else
/// their large share of the inverse would drown the others in single precision.
Matrix6d holdingFreeMotions(const Matrix6d& block) {
  const auto diagonal = block.diagonal().array();
  const Eigen::Array<double, 6, 1> root = (diagonal > 0).select(diagonal.max(1e-30).sqrt(), 1.0);
  const Matrix6d scaling = root.matrix().asDiagonal();
  const Matrix6d scaled = scaling.inverse() * block * scaling.inverse();
  const Eigen::SelfAdjointEigenSolver<Matrix6d> eigen(scaled);
  const Eigen::Matrix<double, 6, 1> isFree =
      (eigen.eigenvalues().array() < kFree).cast<double>().matrix();
  return scaling * eigen.eigenvectors() * isFree.asDiagonal() * eigen.eigenvectors().transpose() *
         scaling;
}

}  // namespace

MatrixXd orthonormalRigidMotions(const Eigen::Matrix3Xd& centres) {
  const Vector3d middle = centres.rowwise().mean();
  MatrixXd motions = MatrixXd::Zero(6 * centres.cols(), 6);
  for (Eigen::Index n = 0; n < centres.cols(); ++n) {
    motions.block<3, 3>(6 * n, 0).setIdentity();
    motions.block<3, 3>(6 * n + 3, 3).setIdentity();
    for (int axis = 0; axis < 3; ++axis) {
      motions.block<3, 1>(6 * n, 3 + axis) = Vector3d::Unit(axis).cross(centres.col(n) - middle);
    }
  }
  return Eigen::HouseholderQR<MatrixXd>(motions).householderQ() *
         MatrixXd::Identity(motions.rows(), 6);
}

MatrixXd computeCoarsestInverse(const MatrixXd& matrix, const Eigen::Matrix3Xd& centres) {
  if (!matrix.allFinite()) {
    throw DeviceError("the multigrid solver's coarsest matrix is not finite");
  }
  const MatrixXd rigid = orthonormalRigidMotions(centres);
  MatrixXd definite = matrix + matrix.diagonal().mean() * rigid * rigid.transpose();
  for (Eigen::Index n = 0; n < matrix.rows(); n += 6) {
    definite.block<6, 6>(n, n) += holdingFreeMotions(matrix.block<6, 6>(n, n));
  }
  const MatrixXd identity = MatrixXd::Identity(matrix.rows(), matrix.cols());
  for (double shift = kLeastShift;; shift *= 10) {
    MatrixXd shifted = definite;
    shifted.diagonal() += shift * definite.diagonal();
    const Eigen::LLT<MatrixXd> factors(shifted);
    if (factors.info() == Eigen::Success) {
      return factors.solve(identity);
    }
  }
}

}  // namespace morphgrid
