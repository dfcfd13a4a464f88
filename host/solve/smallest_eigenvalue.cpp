#include "solve/smallest_eigenvalue.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <chrono>
#include <random>

#include "core/error.h"
#include "core/interrupt.h"
#include "energy/exact_hessian.h"
#include "energy/grid_energy.h"
#include "energy/strut_energy.h"

namespace morphgrid {
namespace {

using Eigen::Index;
using Eigen::Matrix3Xd;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using Clock = std::chrono::steady_clock;

// Motions that are searched side by side: with two, a close second eigenvalue slows the first less;
// more cost more than they spare.
constexpr Index kBlock = 2;
// What rounding leaves of an eigenvalue of zero, over the mean stiffness.
constexpr double kRounding = 1e-13;
// A motion of which less than this share is left has been in the span of the others.
constexpr double kDependent = 1e-10;

MatrixXd joined(const MatrixXd& left, const MatrixXd& right) {
  MatrixXd both(left.rows(), left.cols() + right.cols());
  both << left, right;
  return both;
}

/// The part of `candidates` outside the span of `basis`, by Gram-Schmidt, done twice. Columns that
/// depend on others are left out. All columns of a basis are orthonormal.
MatrixXd orthonormalised(const MatrixXd& candidates, const MatrixXd& basis) {
  MatrixXd result(candidates.rows(), candidates.cols());
  Index count = 0;
  for (VectorXd v : candidates.colwise()) {
    bool independent = v.norm() > 0;
    for (int pass = 0; pass < 2 && independent; ++pass) {
      v.normalize();
      v -= basis * (basis.transpose() * v);
      v -= result.leftCols(count) * (result.leftCols(count).transpose() * v);
      independent = v.norm() > kDependent;
    }
    if (independent) {
      result.col(count++) = v.normalized();
    }
  }
  return result.leftCols(count);
}

VectorXd flattened(const Matrix3Xd& motion) {
  return Eigen::Map<const VectorXd>(motion.data(), motion.size());
}

Matrix3Xd unflattened(const VectorXd& values) {
  return Eigen::Map<const Matrix3Xd>(values.data(), 3, values.size() / 3);
}

/// A basis of translations and infinitesimal rotations, in the plane or in space.
MatrixXd rigidMotions(const Matrix3Xd& positions, Motions motions) {
  const Matrix3Xd centred = positions.colwise() - positions.rowwise().mean();
  MatrixXd basis(positions.size(), 6);
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis);
    basis.col(axis) = unit.replicate(positions.cols(), 1);
    basis.col(3 + axis) = flattened(centred.colwise().cross(unit));
  }
  const std::vector<int> columns =
      motions == Motions::inPlane ? std::vector{0, 1, 5} : std::vector{0, 1, 2, 3, 4, 5};
  return orthonormalised(basis(Eigen::all, columns), MatrixXd(basis.rows(), 0));
}

/// Those of a frame that nothing holds: displacements in spacings, then turns.
MatrixXd rigidMotionsOfFrame(const StrutGrid& grid, const Matrix3Xd& positions) {
  const Index count = positions.cols();

  const Matrix3Xd centred = (positions.colwise() - positions.rowwise().mean()) / grid.spacing;
  MatrixXd basis = MatrixXd::Zero(6 * count, 6);
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis);
    basis.col(axis).head(3 * count) = unit.replicate(count, 1);
    basis.col(3 + axis).head(3 * count) = -flattened(centred.colwise().cross(unit));
    basis.col(3 + axis).tail(3 * count) = unit.replicate(count, 1);
  }
  return orthonormalised(basis(Eigen::all, freeMotions(grid)), MatrixXd(basis.rows(), 0));
}

/// H of a frame in its unknowns as above, over the mean stiffness.
class FrameOperator {
 public:
  FrameOperator(const StrutGrid& grid, const Matrix3Xd& positions, const JointRotations& rotations)
      : spacing_(grid.spacing),
        stiffness_(GridEnergy(grid).meanStiffness()),
        lower_(FrameEnergy(grid).hessian(positions, rotations, FrameEnergy::Definiteness::exact)) {}

  Matrix3Xd operator()(const Matrix3Xd& motion) const {
    const Index count = motion.cols() / 2;
    Matrix3Xd joined(3, motion.cols());  // The unknowns of a joint together.
    joined(Eigen::all, Eigen::seqN(0, count, 2)) = spacing_ * motion.leftCols(count);
    joined(Eigen::all, Eigen::seqN(1, count, 2)) = motion.rightCols(count);
    const VectorXd product = lower_.selfadjointView<Eigen::Lower>() * flattened(joined);
    const Matrix3Xd images = unflattened(product) / (stiffness_ * spacing_ * spacing_);
    Matrix3Xd result(3, motion.cols());
    result.leftCols(count) = spacing_ * images(Eigen::all, Eigen::seqN(0, count, 2));
    result.rightCols(count) = images(Eigen::all, Eigen::seqN(1, count, 2));
    return result;
  }

 private:
  double spacing_;
  double stiffness_;
  Eigen::SparseMatrix<double> lower_;
};

/// H over the mean stiffness, and its preconditioner, on motions that are allowed.
class Problem {
 public:
  using Operator = std::function<Matrix3Xd(const Matrix3Xd&)>;

  Problem(Operator hessian, const Preconditioner& preconditioner, MatrixXd rigid, Motions motions)
      : hessian_(std::move(hessian)),
        preconditioner_(preconditioner),
        motions_(motions),
        rigid_(std::move(rigid)) {}

  Index size() const { return rigid_.rows(); }

  MatrixXd images(const MatrixXd& z) const { return apply(z, hessian_); }

  /// Without rigid motions, orthonormal.
  MatrixXd allowed(const MatrixXd& motions) const { return orthonormalised(motions, rigid_); }

  /// New motions in the directions of the preconditioned `right`, orthonormal to all others.
  MatrixXd newMotions(const MatrixXd& right, const MatrixXd& known) const {
    // Directions are scaled to norm 1, since preconditioners may be of single precision.
    return orthonormalised(apply(right.colwise().normalized(), preconditioner_),
                           joined(rigid_, known));
  }

 private:
  MatrixXd apply(const MatrixXd& vectors, const Operator& operate) const {
    MatrixXd results(vectors.rows(), vectors.cols());
    for (Index n = 0; n < vectors.cols(); ++n) {
      Matrix3Xd result = operate(unflattened(vectors.col(n)));
      if (motions_ == Motions::inPlane) {
        result.row(2).setZero();
      }
      results.col(n) = flattened(result);
    }
    return results;
  }

  Operator hessian_;
  const Preconditioner& preconditioner_;
  Motions motions_;
  MatrixXd rigid_;
};

/// Orthonormal motions with their images under H. The first `eigenvalues.size()` are approximate
/// eigenvectors, the others the directions in which they last changed.
struct Subspace {
  MatrixXd motions;
  MatrixXd images;
  VectorXd eigenvalues;
};

/// The best approximations in the span of the subspace (Rayleigh, Ritz). `kept`: how many of its
/// motions were approximations before.
Subspace improved(const Subspace& s, Index kept) {
  const MatrixXd small = s.motions.transpose() * s.images;
  const Eigen::SelfAdjointEigenSolver<MatrixXd> solver((small + small.transpose()) / 2);
  const Index count = std::min(kBlock, small.cols());
  const MatrixXd best = solver.eigenvectors().leftCols(count);
  MatrixXd changes = best;
  changes.topRows(kept).setZero();
  const MatrixXd coefficients = joined(best, orthonormalised(changes, best));
  return {s.motions * coefficients, s.images * coefficients, solver.eigenvalues().head(count)};
}

Subspace extended(const Subspace& s, const MatrixXd& motions, const Problem& problem) {
  return {joined(s.motions, motions), joined(s.images, problem.images(motions)), s.eigenvalues};
}

MatrixXd randomMotions(Index size) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> value(-1, 1);
  return MatrixXd::NullaryExpr(size, kBlock, [&] { return value(random); });
}

SmallestEigenvalue search(const Problem& problem, const EigenvalueOptions& options) {
  const auto start = Clock::now();
  const Index size = problem.size();
  Subspace s{MatrixXd(size, 0), MatrixXd(size, 0), VectorXd(0)};
  const MatrixXd first = options.start.size() == size
                             ? problem.allowed(flattened(options.start))
                             : problem.newMotions(randomMotions(size), s.motions);
  if (first.cols() == 0) {
    throw DeviceError("the preconditioner of the eigenvalue search left the range of numbers");
  }
  s = improved(extended(s, first, problem), 0);

  SmallestEigenvalue result;
  for (;; ++result.iterations) {
    const Index count = s.eigenvalues.size();
    const MatrixXd residuals =
        s.images.leftCols(count) - s.motions.leftCols(count) * s.eigenvalues.asDiagonal();
    result.value = s.eigenvalues[0];
    result.residual = residuals.col(0).norm();
    result.converged =
        result.residual <= std::max(options.tolerance * std::abs(result.value), kRounding) ||
        result.value - result.residual > options.enough;
    if (result.converged || result.iterations >= options.iterationLimit || interruptRequested()) {
      break;
    }
    s = improved(extended(s, problem.newMotions(residuals, s.motions), problem), count);
  }
  result.motion = unflattened(s.motions.col(0));
  result.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return result;
}

}  // namespace

Verdict verdictOf(const SmallestEigenvalue& eigenvalue) {
  if (eigenvalue.value < -kRounding) {
    return Verdict::saddle;
  }
  return eigenvalue.converged && eigenvalue.value > eigenvalue.residual ? Verdict::minimum
                                                                        : Verdict::undecided;
}

std::string toString(Verdict verdict) {
  switch (verdict) {
    case Verdict::minimum:
      return "minimum";
    case Verdict::saddle:
      return "saddle";
    case Verdict::undecided:
      return "undecided";
  }
  return "unknown";
}

SmallestEigenvalue computeSmallestEigenvalue(const StrutGrid& grid, const Matrix3Xd& positions,
                                             const Preconditioner& preconditioner,
                                             const EigenvalueOptions& options) {
  const ExactHessian hessian(grid, positions);
  const double stiffness = StrutEnergy(grid).meanStiffness();
  return search(
      Problem([&](const Matrix3Xd& z) { return Matrix3Xd(hessian.product(z) / stiffness); },
              preconditioner, rigidMotions(positions, options.motions), options.motions),
      options);
}

SmallestEigenvalue computeSmallestEigenvalue(const StrutGrid& grid, const Matrix3Xd& positions,
                                             const JointRotations& rotations,
                                             const Preconditioner& preconditioner,
                                             const EigenvalueOptions& options) {
  return search(Problem(FrameOperator(grid, positions, rotations), preconditioner,
                        rigidMotionsOfFrame(grid, positions), Motions::inSpace),
                options);
}

}  // namespace morphgrid
