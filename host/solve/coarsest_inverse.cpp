#include "solve/coarsest_inverse.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <Eigen/QR>

#include "core/error.h"

namespace morphgrid {
namespace {

using Eigen::MatrixXd;
using Eigen::Vector3d;

/// Share of the diagonal that is added to it: rounding in single precision may have made soft
/// motions negative. More is tried where that does not suffice.
constexpr double kLeastShift = 1e-6;

}  // namespace

MatrixXd orthonormalRigidMotions(const Eigen::Matrix3Xd& centres) {
  const Vector3d middle = centres.rowwise().mean();
  MatrixXd motions = MatrixXd::Zero(6 * centres.cols(), 6);
  for (Eigen::Index n = 0; n < centres.cols(); ++n) {
    motions.block<3, 3>(6 * n, 0).setIdentity();
    motions.block<3, 3>(6 * n + 3, 3).setIdentity();
    for (int axis = 0; axis < 3; ++axis) {
      motions.block<3, 1>(6 * n, 3 + axis) =
          Vector3d::Unit(axis).cross(centres.col(n) - middle);
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
  const Eigen::VectorXd diagonal = matrix.diagonal();
  MatrixXd definite = matrix + diagonal.mean() * rigid * rigid.transpose();
  definite.diagonal() += (diagonal.array() <= 0).cast<double>().matrix();
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
