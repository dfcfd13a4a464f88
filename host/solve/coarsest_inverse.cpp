#include "solve/coarsest_inverse.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <Eigen/LU>
#include <Eigen/QR>
#include <utility>
#include <vector>

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

/// Turns the inverse of A into that of A - s E E^T + s R R^T by Woodbury's formula: E are the six
/// motions of a point, R others.
void exchangeStiffness(MatrixXd& inverse, Eigen::Index point, const MatrixXd& motions,
                       double stiffness) {
  const Eigen::Index count = motions.cols();
  MatrixXd changed = MatrixXd::Zero(inverse.rows(), 6 + count);
  changed.block<6, 6>(point, 0).setIdentity();
  changed.rightCols(count) = motions;
  const MatrixXd moved = inverse * changed;
  MatrixXd small = changed.transpose() * moved;
  small.diagonal().head<6>().array() -= 1 / stiffness;
  small.diagonal().tail(count).array() += 1 / stiffness;
  inverse -= moved * small.fullPivLu().solve(moved.transpose());
}

}  // namespace

std::optional<MatrixXd> invertBlockTridiagonal(const MatrixXd& matrix, Eigen::Index blockSize) {
  const Eigen::Index b = blockSize;
  const Eigen::Index size = matrix.rows();
  std::vector<MatrixXd> pivots;   // Inverse Schur complements S_n^-1.
  std::vector<MatrixXd> factors;  // A_(n+1,n) S_n^-1
  MatrixXd schur = matrix.topLeftCorner(b, b);
  for (Eigen::Index at = 0;; at += b) {
    const Eigen::LLT<MatrixXd> cholesky(schur);
    if (cholesky.info() != Eigen::Success) {
      return std::nullopt;
    }
    pivots.push_back(cholesky.solve(MatrixXd::Identity(b, b)));
    if (at + b == size) {
      break;
    }
    const auto below = matrix.block(at + b, at, b, b);
    factors.push_back(below * pivots.back());
    schur = matrix.block(at + b, at + b, b, b) - factors.back() * below.transpose();
  }
  MatrixXd inverse(size, size);
  inverse.bottomRightCorner(b, b) = pivots.back();
  for (auto n = static_cast<Eigen::Index>(factors.size()); n-- > 0;) {
    const MatrixXd& factor = factors[static_cast<std::size_t>(n)];
    const Eigen::Index at = n * b;
    const Eigen::Index next = at + b;
    auto right = inverse.block(at, next, b, size - next);
    right.noalias() = -factor.transpose() * inverse.block(next, next, b, size - next);
    inverse.block(at, at, b, b) = pivots[static_cast<std::size_t>(n)] - right.leftCols(b) * factor;
    inverse.block(next, at, size - next, b) = right.transpose();
  }
  return inverse;
}

MatrixXd orthonormalRigidMotions(const Eigen::Matrix3Xd& centres, const std::vector<int>& motions) {
  const Vector3d middle = centres.rowwise().mean();
  MatrixXd all = MatrixXd::Zero(6 * centres.cols(), 6);
  for (Eigen::Index n = 0; n < centres.cols(); ++n) {
    all.block<3, 3>(6 * n, 0).setIdentity();
    all.block<3, 3>(6 * n + 3, 3).setIdentity();
    for (int axis = 0; axis < 3; ++axis) {
      all.block<3, 1>(6 * n, 3 + axis) = Vector3d::Unit(axis).cross(centres.col(n) - middle);
    }
  }
  return Eigen::HouseholderQR<MatrixXd>(all(Eigen::all, motions)).householderQ() *
         MatrixXd::Identity(all.rows(), static_cast<Eigen::Index>(motions.size()));
}

MatrixXd computeCoarsestInverse(const MatrixXd& matrix, const Eigen::Matrix3Xd& centres,
                                Eigen::Index pointsPerRow, const std::vector<int>& free) {
  if (!matrix.allFinite()) {
    throw DeviceError("the multigrid solver's coarsest matrix is not finite");
  }
  const double stiffness = matrix.diagonal().mean();
  MatrixXd held = matrix;
  for (Eigen::Index n = 0; n < matrix.rows(); n += 6) {
    held.block<6, 6>(n, n) += holdingFreeMotions(matrix.block<6, 6>(n, n));
  }
  // Rigid motions would couple all rows: a point that is held takes their place until the inverse
  // is there.
  const Eigen::Index heldPoint = 6 * (centres.cols() / 2);
  if (!free.empty()) {
    held.block<6, 6>(heldPoint, heldPoint).diagonal().array() += stiffness;
  }
  for (double shift = kLeastShift;; shift *= 10) {
    MatrixXd shifted = held;
    shifted.diagonal() += shift * held.diagonal();
    if (auto inverse = invertBlockTridiagonal(shifted, 6 * pointsPerRow)) {
      if (!free.empty()) {
        exchangeStiffness(*inverse, heldPoint, orthonormalRigidMotions(centres, free), stiffness);
      }
      return std::move(*inverse);
    }
  }
}

}  // namespace morphgrid
