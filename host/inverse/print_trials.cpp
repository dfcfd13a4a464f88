#include "inverse/print_trials.h"

#include <algorithm>

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
  if (error_.objective == 0) return std::nullopt;
  place(rest_);
  const Adjoint adjoint =
      solver_.solveAdjoint(error_.gradient, {.tolerance = kSlopeTolerance, .productLimit = 400});
  if (!adjoint.converged) return std::nullopt;
  const LateralRest lateral(solver_.grid().shape);
  // RMS = c sqrt(J), so that dRMS = RMS / (2 J) dJ.
  return Eigen::VectorXd(error_.rmsPercent / (2 * error_.objective) *
                         lateral.gradient(solver_.grid(), centre_, adjoint.lambda));
}

}  // namespace morphgrid
