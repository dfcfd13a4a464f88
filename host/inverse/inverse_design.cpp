#include "inverse/inverse_design.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "solve/morph_course.h"
#include "solve/multigrid_solver.h"

namespace morphgrid {
namespace {

using Eigen::VectorXd;

// Where no bound is asked for, a rest length stays within this share of the designed one.
constexpr double kTrust = 0.3;
// Of the spacing: the first step along the gradient, and the largest change of a rest length.
constexpr double kFirstStep = 0.02;
constexpr double kLargestStep = 0.1;
constexpr int kLineSearchSteps = 6;
constexpr double kBacktracking = 0.3;
// On the way an equilibrium need not be better than the distance that it is measured for.
constexpr double kEnergyTolerance = 1e-8;
// After so many steps the equilibrium is solved as well as the last one will be.
constexpr int kStepsToSettle = 10;
// So many times the objective: the grid has left for another equilibrium.
constexpr double kGaveWay = 1.1;
// Of the slow morph from flat.
constexpr int kMorphSteps = 4;
// Relative: equilibria whose energies differ by more are not the same.
constexpr double kSameEnergy = 1e-5;
// No longer falls: the objective, over so many steps, by less than this share.
constexpr std::size_t kPatience = 6;
constexpr double kLeastFall = 0.02;

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

VectorXd lowest(const VectorXd& designed, const VectorXd& printed,
                const std::optional<double>& shrinkLimit) {
  return shrinkLimit ? VectorXd((1 - *shrinkLimit) * printed) : VectorXd((1 - kTrust) * designed);
}

VectorXd highest(const VectorXd& designed, const VectorXd& printed,
                 const std::optional<double>& shrinkLimit) {
  return shrinkLimit ? printed : VectorXd((1 + kTrust) * designed);
}

}  // namespace

std::string toString(InverseStep::Kind kind) {
  switch (kind) {
    case InverseStep::Kind::design:
      return "design";
    case InverseStep::Kind::compensate:
      return "compensate";
    case InverseStep::Kind::optimise:
      break;
  }
  return "optimise";
}

InverseDesigner::InverseDesigner(const Device& device, StrutGrid& grid, DeviceGrid& deviceGrid,
                                 const Eigen::Matrix3Xd& targets, InverseOptions options)
    : device_(device),
      grid_(grid),
      deviceGrid_(deviceGrid),
      targets_(targets),
      options_(std::move(options)),
      lateral_(grid.shape),
      designed_(lateral_.of(grid)),
      printed_(lateral_.lengthsAt(grid.positions)),
      low_(lowest(designed_, printed_, options_.shrinkLimit)),
      high_(highest(designed_, printed_, options_.shrinkLimit)),
      lbfgs_(low_, high_),
      adjoint_(device, deviceGrid) {}

InverseDesign InverseDesigner::run(Equilibrium first) {
  start_ = now();
  begin(std::move(first));
  compensate();
  if (!settle()) {
    state_ = kept_;
  }
  optimise();
  if (options_.solve.stopRequested()) {
    result_.ending = "interrupted";
  }
  if (!settle()) {
    result_.ending =
        fmt::format("in step {} the grid left for another equilibrium", result_.steps.size() - 1);
    result_.steps.resize(keptSteps_);
  }
  lateral_.set(grid_, kept_.rest);
  morphFromFlat();
  deviceGrid_.uploadRest(grid_.rest);
  deviceGrid_.uploadPositions(kept_.equilibrium.positions);
  result_.equilibrium = std::move(kept_.equilibrium);
  return std::move(result_);
}

void InverseDesigner::begin(Equilibrium first) {
  const VectorXd rest = lbfgs_.project(designed_);
  ShapeError error = computeShapeError(grid_.shape, first.positions, targets_);
  state_ = {designed_, std::move(first), std::move(error)};
  if (rest != designed_) {
    state_ = morphed(rest, kEnergyTolerance);
  }
  result_.ending = "all steps done";
  log(InverseStep::Kind::design, 0);
  keep();
}

void InverseDesigner::keep() {
  kept_ = state_;
  keptSteps_ = result_.steps.size();
}

/// Keeps the present design if its equilibrium holds when it is solved to the end.
bool InverseDesigner::settle() {
  State settled = morphed(state_.rest, options_.solve.energyTolerance);
  if (settled.error.objective > kGaveWay * state_.error.objective) {
    return false;
  }
  state_ = std::move(settled);
  keep();
  return true;
}

/// What is printed starts flat, not at the last design's equilibrium.
void InverseDesigner::morphFromFlat() {
  SolveOptions solve = options_.solve;
  solve.onProgress = nullptr;  // Who looks on sees the designed grid.
  solve.onGrid = nullptr;
  const Equilibrium end = followMorph(device_, grid_, {.steps = kMorphSteps, .solve = solve}).end;
  if (options_.solve.stopRequested()) {
    return;
  }
  const double energy = kept_.equilibrium.energy;
  result_.fromFlat =
      FromFlat{.sameEquilibrium = std::abs(end.energy - energy) <= kSameEnergy * energy,
               .rmsPercent = computeShapeError(grid_.shape, end.positions, targets_).rmsPercent};
}

/// Solves from the present state with other rest lengths.
InverseDesigner::State InverseDesigner::morphed(const VectorXd& rest, double energyTolerance) {
  lateral_.set(grid_, rest);
  deviceGrid_.uploadRest(grid_.rest);
  deviceGrid_.uploadPositions(state_.equilibrium.positions);
  SolveOptions solve = options_.solve;
  solve.startsNear = true;
  solve.energyTolerance = energyTolerance;
  Equilibrium equilibrium = solveMultigrid(device_, grid_, deviceGrid_, solve);
  cycles_ += equilibrium.iterations;
  ShapeError error = computeShapeError(grid_.shape, equilibrium.positions, targets_);
  return {rest, std::move(equilibrium), std::move(error)};
}

void InverseDesigner::compensate() {
  for (int round = 1; round <= options_.compensateRounds && !options_.solve.stopRequested();
       ++round) {
    const VectorXd lengths = lateral_.lengthsAt(state_.equilibrium.positions);
    const VectorXd rest = state_.rest.cwiseProduct(designed_).cwiseQuotient(lengths);
    State next = morphed(lbfgs_.project(rest), kEnergyTolerance);
    if (next.error.objective >= state_.error.objective) {
      break;  // It cannot see twist, and may lead away.
    }
    state_ = std::move(next);
    log(InverseStep::Kind::compensate, round);
  }
}

VectorXd InverseDesigner::gradient() {
  lateral_.set(grid_, state_.rest);
  deviceGrid_.uploadRest(grid_.rest);
  deviceGrid_.uploadPositions(state_.equilibrium.positions);
  const Adjoint adjoint = adjoint_.solve(state_.error.gradient);
  products_ += adjoint.products;
  return lateral_.gradient(grid_, state_.equilibrium.positions, adjoint.lambda);
}

bool InverseDesigner::falls() const {
  const std::size_t count = objectives_.size();
  return count <= kPatience ||
         objectives_.back() < (1 - kLeastFall) * objectives_[count - 1 - kPatience];
}

void InverseDesigner::optimise() {
  VectorXd slope;
  for (int step = 1; step <= options_.optimiseSteps && !options_.solve.stopRequested(); ++step) {
    if (slope.size() == 0) {
      slope = gradient();
    }
    const VectorXd before = state_.rest;
    VectorXd direction = lbfgs_.direction(before, slope, kFirstStep * grid_.spacing);
    direction *= std::min(1.0, kLargestStep * grid_.spacing / direction.cwiseAbs().maxCoeff());
    if (!searchLine(direction)) {
      if (lbfgs_.empty()) {
        result_.ending = "the distance no longer falls";
        return;
      }
      lbfgs_.clear();
      continue;
    }
    const VectorXd newSlope = gradient();
    lbfgs_.add(state_.rest - before, newSlope - slope);
    slope = newSlope;
    log(InverseStep::Kind::optimise, step);
    if (step % kStepsToSettle == 0 && !settle()) {
      return;
    }
    objectives_.push_back(state_.error.objective);
    if (!falls()) {
      result_.ending = "the distance no longer falls";
      return;
    }
  }
}

bool InverseDesigner::searchLine(const VectorXd& direction) {
  double length = 1;
  for (int attempt = 0; attempt < kLineSearchSteps && !options_.solve.stopRequested(); ++attempt) {
    State next = morphed(lbfgs_.project(state_.rest + length * direction), kEnergyTolerance);
    if (next.equilibrium.converged && next.error.objective < state_.error.objective) {
      state_ = std::move(next);
      return true;
    }
    length *= kBacktracking;
  }
  return false;
}

void InverseDesigner::log(InverseStep::Kind kind, int number) {
  const VectorXd shrink = 1 - state_.rest.array() / printed_.array();
  const long atBound =
      (state_.rest.array() <= low_.array() || state_.rest.array() >= high_.array()).count();
  result_.steps.push_back({kind, number, state_.error.rmsPercent, state_.error.maxPercent,
                           100 * shrink.maxCoeff(), atBound, std::exchange(cycles_, 0),
                           std::exchange(products_, 0), now() - start_});
  if (options_.onStep) {
    options_.onStep(result_.steps.back());
  }
}

}  // namespace morphgrid
