#include "inverse/print_trials.h"

#include <Eigen/QR>
#include <algorithm>
#include <random>

#include "core/intrinsic_diagonal.h"

namespace morphgrid {
namespace {

// A trial takes tens of cycles; one that takes more than this has left.
constexpr long kMostTrialCycles = 1000;
// The way back need not be solved as well: only whether it leads back counts.
constexpr double kWayBackTolerance = 1e-7;
// It does where this share of the way is left, or less than so much, in percent of the diagonal.
constexpr double kShareLeft = 0.25;
constexpr double kNoWay = 0.02;
constexpr double kSlopeTolerance = 1e-4;
constexpr double kMovementTolerance = 0.01;
// In percent: positions in single precision tell no less.
constexpr double kNoDistance = 1e-3;

}  // namespace

PrintTrials::PrintTrials(MultigridSolver& solver, const Equilibrium& near,
                         const Eigen::Matrix3Xd& goal, SolveOptions options)
    : solver_(solver), goal_(goal), options_(std::move(options)), rest_(solver.grid().rest) {
  options_.startsNear = true;
  options_.iterationLimit = std::min(options_.iterationLimit, kMostTrialCycles);
  options_.onCheckpoint = nullptr;
  options_.onProgress = nullptr;
  options_.onGrid = nullptr;
  options_.resumeFrom.reset();
  solver_.moveTo(near.positions, near.rotations);
  centre_ = solver_.solve(options_);
  error_ = computeShapeError(solver_.grid().shape, centre_.positions, goal_);
}

void PrintTrials::place(const StrutValues& rest) {
  solver_.setRest(rest);
  solver_.moveTo(centre_.positions, centre_.rotations);
}

PrintTrial PrintTrials::tryWith(const StrutValues& rest) {
  place(rest);
  const GridShape& shape = solver_.grid().shape;
  const Equilibrium end = solver_.solve(options_);
  PrintTrial trial{computeShapeError(shape, end.positions, goal_), end.converged, false};
  trial.isJump = !options_.stopRequested() && !comesBack(middleLayer(shape, end.positions));
  return trial;
}

/// From where the solver stands; middle: the middle layer there.
bool PrintTrials::comesBack(const Eigen::Matrix3Xd& middle) {
  const GridShape& shape = solver_.grid().shape;
  const auto wayFrom = [&](const Eigen::Matrix3Xd& points) {
    return computeShapeError(shape, centre_.positions, points).rmsPercent;
  };
  const double way = wayFrom(middle);
  if (way <= kNoWay) return true;
  SolveOptions back = options_;
  back.energyTolerance = std::max(back.energyTolerance, kWayBackTolerance);
  back.quietSteps = 1;
  solver_.setRest(rest_);
  const Equilibrium end = solver_.solve(back);
  return wayFrom(middleLayer(shape, end.positions)) <= std::max(kNoWay, kShareLeft * way);
}

std::optional<Eigen::VectorXd> PrintTrials::slope() {
  if (error_.rmsPercent < kNoDistance) return std::nullopt;
  place(rest_);
  const Adjoint adjoint =
      solver_.solveAdjoint(error_.gradient, {.tolerance = kSlopeTolerance, .productLimit = 400});
  if (!adjoint.converged) return std::nullopt;
  const LateralRest lateral(solver_.grid().shape);
  // RMS = c sqrt(J), so that dRMS = RMS / (2 J) dJ.
  return Eigen::VectorXd(error_.rmsPercent / (2 * error_.objective) *
                         lateral.gradient(solver_.grid(), centre_, adjoint.lambda));
}

/// Of the middle layer, orthonormal: a column each, its points' coordinates one after another.
Eigen::MatrixXd PrintTrials::rigidMotions() const {
  Eigen::Matrix3Xd middle = middleLayer(solver_.grid().shape, centre_.positions);
  middle.colwise() -= middle.rowwise().mean().eval();
  Eigen::MatrixXd motions(middle.size(), 6);
  for (int axis = 0; axis < 3; ++axis) {
    const Eigen::Vector3d unit = Eigen::Vector3d::Unit(axis);
    for (Eigen::Index n = 0; n < middle.cols(); ++n) {
      motions.block<3, 1>(3 * n, axis) = unit;
      motions.block<3, 1>(3 * n, 3 + axis) = unit.cross(middle.col(n));
    }
  }
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(motions);
  return qr.householderQ() * Eigen::MatrixXd::Identity(motions.rows(), 6);
}

Eigen::MatrixXd PrintTrials::movements(int rows, std::uint64_t seed) {
  const GridShape& shape = solver_.grid().shape;
  const LateralRest lateral(shape);
  const Eigen::MatrixXd rigid = rigidMotions();
  const double percent = 100 / (intrinsicDiagonal(goal_) * std::sqrt(shape.layerVertexCount()));
  std::mt19937_64 generator(seed);
  Eigen::MatrixXd result(rows, lateral.size());
  int done = 0;
  place(rest_);
  for (int row = 0; row < rows && !options_.stopRequested(); ++row) {
    Eigen::VectorXd random(rigid.rows());
    for (double& sign : random) sign = generator() % 2 == 0 ? 1 : -1;
    random -= rigid * (rigid.transpose() * random).eval();
    const Eigen::Map<const Eigen::Matrix3Xd> middle(random.data(), 3, shape.layerVertexCount());
    Eigen::Matrix3Xd forces = Eigen::Matrix3Xd::Zero(3, shape.vertexCount());
    layerOf(shape, forces, (shape.layers - 1) / 2) += 0.5 * middle;
    layerOf(shape, forces, shape.layers / 2) += 0.5 * middle;
    const Adjoint adjoint = solver_.solveAdjoint(forces, {.tolerance = kMovementTolerance});
    if (!adjoint.converged) continue;
    result.row(done++) = percent * lateral.gradient(solver_.grid(), centre_, adjoint.lambda);
  }
  return result.topRows(done) / std::sqrt(std::max(1, done));
}

}  // namespace morphgrid
