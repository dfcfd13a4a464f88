#include "inverse/inverse_design.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

#include "core/bounding_diagonal.h"
#include "inverse/aim_correction.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
using Eigen::VectorXd;

// Where no bound is asked for, a rest length stays within this share of the designed one.
constexpr double kTrust = 0.3;
// The first step along the gradient and the largest change of a rest length, in spacings.
constexpr double kFirstStep = 0.02;
constexpr double kLargestStep = 0.1;
constexpr int kLineSearchSteps = 6;
constexpr double kBacktracking = 0.3;
// On the way an equilibrium need not be better than the distance that it is measured for.
constexpr double kEnergyTolerance = 1e-8;
// A tighter adjoint gives no better step (tried: 1e-3 takes half as many products more).
constexpr double kAdjointTolerance = 0.01;
constexpr int kQuietSteps = 1;
// After so many steps the equilibrium is solved as well as the last one will be.
constexpr int kStepsToSettle = 10;
// Strains count from this share of their bound on, so that what is left of them is within it.
constexpr double kStrainMargin = 0.9;
// RMS in percent: no printer is as precise.
constexpr double kCloseEnough = 0.005;
// So many times the objective: the grid has left for another equilibrium.
constexpr double kGaveWay = 1.1;
// No longer falls: the objective, over so many steps, by less than this share.
constexpr std::size_t kPatience = 6;
constexpr double kLeastFall = 0.02;

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// valueOf(range) times the printed length, one a strut.
template <typename ValueOf>
VectorXd withinBounds(const VectorXd& printed, const ShrinkBounds& bounds, const ValueOf& valueOf) {
  return printed.unaryExpr([&](double length) { return valueOf(bounds.at(length)) * length; });
}

VectorXd lowest(const VectorXd& designed, const VectorXd& printed,
                const std::optional<ShrinkBounds>& bounds) {
  return bounds ? withinBounds(printed, *bounds, [](const ShrinkRange& r) { return 1 - r.most; })
                : VectorXd((1 - kTrust) * designed);
}

VectorXd highest(const VectorXd& designed, const VectorXd& printed,
                 const std::optional<ShrinkBounds>& bounds) {
  return bounds ? withinBounds(printed, *bounds, [](const ShrinkRange& r) { return 1 - r.least; })
                : VectorXd((1 + kTrust) * designed);
}

}  // namespace

InverseDesigner::InverseDesigner(MultigridSolver& solver, const Eigen::Matrix3Xd& targets,
                                 InverseOptions options)
    : solver_(solver),
      targets_(targets),
      options_(std::move(options)),
      onTheWay_(options_.solve),
      toTheEnd_(options_.solve),
      lateral_(solver.grid().shape),
      designed_(lateral_.of(solver.grid())),
      printed_(lateral_.lengthsAt(solver.grid().positions)),
      low_(lowest(designed_, printed_, options_.shrinkBounds)),
      high_(highest(designed_, printed_, options_.shrinkBounds)),
      diagonal_(boundingDiagonal(targets)),
      lbfgs_(low_, high_),
      pace_(options_.onCheckpoint),
      aim_(targets) {
  for (SolveOptions* solve : {&onTheWay_, &toTheEnd_}) {
    solve->startsNear = true;
    solve->onCheckpoint = nullptr;
    solve->resumeFrom.reset();
  }
  onTheWay_.energyTolerance = kEnergyTolerance;
  onTheWay_.quietSteps = kQuietSteps;
}

InverseDesign InverseDesigner::run(Equilibrium first) {
  result_.ending = "all steps done";
  if (solver_.grid().bars) {
    softness_.emplace(solver_, options_.softest);
    solver_.moveTo(first.positions, first.rotations);
  }
  if (options_.resumeFrom) {
    resume(std::move(*options_.resumeFrom));
  } else {
    start_ = now();
    begin(std::move(first));
  }
  if (softness_) {
    place();
    softness_->startAt(state_.rest, state_.equilibrium);
  }
  if (!compensated_) {
    compensate();
    if (!options_.solve.stopRequested() && !settle()) {
      state_ = kept_;
      isPlaced_ = false;
    }
    compensated_ = !options_.solve.stopRequested();
  }
  optimise();
  offerCheckpoint();
  if (options_.solve.stopRequested()) {
    result_.ending = "interrupted";
  }
  if (!settle()) {
    result_.ending =
        fmt::format("in step {} the grid left for another equilibrium", result_.steps.size() - 1);
    result_.steps.resize(keptSteps_);
  }
  result_.rest = lateral_.replacedIn(solver_.grid(), kept_.rest);
  solver_.setRest(result_.rest);
  solver_.moveTo(kept_.equilibrium.positions, kept_.equilibrium.rotations);
  morphFromFlat();
  solver_.moveTo(kept_.equilibrium.positions, kept_.equilibrium.rotations);
  result_.equilibrium = std::move(kept_.equilibrium);
  return std::move(result_);
}

std::optional<InverseDesign> InverseDesigner::salvage() const {
  if (result_.steps.empty()) {
    return std::nullopt;
  }
  return InverseDesign{lateral_.replacedIn(solver_.grid(), state_.rest), state_.equilibrium,
                       result_.steps, "device failure", std::nullopt};
}

void InverseDesigner::begin(Equilibrium first) {
  const VectorXd rest = lbfgs_.project(designed_);
  state_ = stateOf({designed_, std::move(first)});
  if (rest != designed_) {
    state_ = morphed(rest, onTheWay_);
    isPlaced_ = true;
  }
  log(InverseStep::Kind::design, 0);
  keep();
}

void InverseDesigner::resume(InverseCheckpoint from) {
  requireSizes(from, lateral_.size(), solver_.grid().shape.vertexCount());
  state_ = stateOf(std::move(from.present));
  kept_ = stateOf(std::move(from.kept));
  keptSteps_ = from.keptSteps;
  if (from.aim.cols() == targets_.cols()) aim_ = std::move(from.aim);
  compensated_ = from.compensated;
  result_.steps = std::move(from.steps);
  objectives_ = std::move(from.objectives);
  lbfgs_.setPairs(std::move(from.pairs));
  start_ = now() - (result_.steps.empty() ? 0 : result_.steps.back().seconds);
}

InverseDesigner::State InverseDesigner::stateOf(InverseCheckpoint::Design design) const {
  ShapeError error =
      computeShapeError(solver_.grid().shape, design.equilibrium.positions, targets_);
  const StrainExcess excess = excessOf(design);
  const double objective = error.objective + excess.penalty;
  return {std::move(design.rest), std::move(design.equilibrium), std::move(error), objective};
}

InverseCheckpoint InverseDesigner::checkpoint() const {
  return {compensated_,
          {state_.rest, state_.equilibrium},
          {kept_.rest, kept_.equilibrium},
          keptSteps_,
          result_.steps,
          objectives_,
          lbfgs_.pairs(),
          aim_};
}

void InverseDesigner::offerCheckpoint() {
  pace_.offer(compensated_ ? 1 : 0, options_.solve.stopRequested(), [&] { return checkpoint(); });
}

void InverseDesigner::keep() {
  kept_ = state_;
  keptSteps_ = result_.steps.size();
}

/// Keeps the present design if its equilibrium holds when it is solved to the end.
bool InverseDesigner::settle() {
  State settled = morphed(state_.rest, toTheEnd_);
  if (settled.objective > kGaveWay * state_.objective) {
    return false;
  }
  state_ = std::move(settled);
  isPlaced_ = true;
  keep();
  return true;
}

void InverseDesigner::morphFromFlat() {
  if (options_.onCheckFromFlat) {
    options_.onCheckFromFlat();
  }
  result_.fromFlat =
      checkFromFlat(solver_, kept_.equilibrium, targets_, toTheEnd_,
                    softness_ ? &softness_->softness() : nullptr, options_.onFromFlat);
  if (softness_) result_.refusedAsSoft = softness_->refusals();
}

void InverseDesigner::place() {
  if (!isPlaced_) {
    solver_.setRest(lateral_.replacedIn(solver_.grid(), state_.rest));
    solver_.moveTo(state_.equilibrium.positions, state_.equilibrium.rotations);
    isPlaced_ = true;
  }
}

/// Solves from the present state with other rest lengths. The solver then stands there.
InverseDesigner::State InverseDesigner::morphed(const VectorXd& rest, const SolveOptions& solve) {
  if (!isPlaced_) {
    solver_.moveTo(state_.equilibrium.positions, state_.equilibrium.rotations);
  }
  isPlaced_ = false;
  solver_.setRest(lateral_.replacedIn(solver_.grid(), rest));
  Equilibrium equilibrium = solver_.solve(solve);
  cycles_ += equilibrium.iterations;
  return stateOf({rest, std::move(equilibrium)});
}

void InverseDesigner::compensate() {
  if (options_.lengthsFor) {
    aimBeyond();
  } else {
    correctLengths();
  }
}

/// By aims that lie beyond the target.
void InverseDesigner::aimBeyond() {
  AimCorrection correction(targets_, aim_);
  const GridShape& shape = solver_.grid().shape;
  for (int round = 1 + roundsDone();
       round <= options_.compensateRounds && !options_.solve.stopRequested() &&
       !correction.isExhausted() && state_.error.rmsPercent > kCloseEnough;
       ++round) {
    offerCheckpoint();
    const Matrix3Xd& aim = correction.next(middleLayer(shape, state_.equilibrium.positions));
    State trial = morphed(lbfgs_.project(options_.lengthsFor(aim)), onTheWay_);
    if (isBetter(trial) && strainsNoMore(trial) && staysFirm(trial)) {
      correction.take();
      aim_ = correction.aim();
      state_ = std::move(trial);
      isPlaced_ = true;
      log(InverseStep::Kind::compensate, round);
    } else {
      correction.refuse();
    }
  }
}

int InverseDesigner::roundsDone() const {
  return static_cast<int>(std::count_if(
      result_.steps.begin(), result_.steps.end(),
      [](const InverseStep& step) { return step.kind == InverseStep::Kind::compensate; }));
}

void InverseDesigner::correctLengths() {
  for (int round = 1 + roundsDone();
       round <= options_.compensateRounds && !options_.solve.stopRequested(); ++round) {
    offerCheckpoint();
    const VectorXd lengths = lateral_.lengthsAt(state_.equilibrium.positions);
    const VectorXd rest = state_.rest.cwiseProduct(designed_).cwiseQuotient(lengths);
    State next = morphed(lbfgs_.project(rest), onTheWay_);
    if (next.objective >= state_.objective) {
      break;  // It cannot see twist, and may lead away.
    }
    state_ = std::move(next);
    isPlaced_ = true;
    log(InverseStep::Kind::compensate, round);
  }
}

StrainExcess InverseDesigner::excessOf(const InverseCheckpoint::Design& design) const {
  return options_.maxStrain
             ? computeStrainExcess(lateral_, design.rest, design.equilibrium.positions,
                                   kStrainMargin * *options_.maxStrain, diagonal_)
             : StrainExcess{};
}

VectorXd InverseDesigner::gradient() {
  place();
  const StrainExcess excess = excessOf({state_.rest, state_.equilibrium});
  Matrix3Xd byPositions = state_.error.gradient;
  if (excess.penalty > 0) byPositions += excess.byPositions;
  const Adjoint adjoint = solver_.solveAdjoint(byPositions, {.tolerance = kAdjointTolerance});
  products_ += adjoint.products;
  VectorXd slope = lateral_.gradient(solver_.grid(), state_.equilibrium, adjoint.lambda);
  if (excess.penalty > 0) slope += excess.byRest;
  return slope;
}

bool InverseDesigner::falls() const {
  const std::size_t count = objectives_.size();
  return count <= kPatience ||
         objectives_.back() < (1 - kLeastFall) * objectives_[count - 1 - kPatience];
}

void InverseDesigner::optimise() {
  VectorXd slope;
  const InverseStep& last = result_.steps.back();
  int step = last.kind == InverseStep::Kind::optimise ? last.number : 0;
  while (++step <= options_.optimiseSteps && !options_.solve.stopRequested()) {
    offerCheckpoint();
    const Outcome outcome = falls() ? improve(slope, step) : Outcome::fallsNoFurther;
    if (outcome == Outcome::fallsNoFurther) {
      result_.ending = "the distance no longer falls";
      return;
    }
    if (outcome == Outcome::better) {
      if (step % kStepsToSettle == 0 && !settle()) {
        return;
      }
      objectives_.push_back(state_.objective);
    }
  }
}

InverseDesigner::Outcome InverseDesigner::improve(VectorXd& slope, int step) {
  if (slope.size() == 0) {
    slope = gradient();
  }
  const VectorXd before = state_.rest;
  const double spacing = solver_.grid().spacing;
  VectorXd direction = lbfgs_.direction(before, slope, kFirstStep * spacing);
  direction *= std::min(1.0, kLargestStep * spacing / direction.cwiseAbs().maxCoeff());
  if (!searchLine(direction)) {
    if (lbfgs_.empty()) {
      return Outcome::fallsNoFurther;
    }
    if (!options_.solve.stopRequested()) {
      lbfgs_.clear();
    }
    return Outcome::searchesAnew;
  }
  const VectorXd newSlope = gradient();
  lbfgs_.add(state_.rest - before, newSlope - slope);
  slope = newSlope;
  log(InverseStep::Kind::optimise, step);
  return Outcome::better;
}

bool InverseDesigner::searchLine(const VectorXd& direction) {
  double length = 1;
  for (int attempt = 0; attempt < kLineSearchSteps && !options_.solve.stopRequested(); ++attempt) {
    State next = morphed(lbfgs_.project(state_.rest + length * direction), onTheWay_);
    if (isBetter(next) && staysFirm(next)) {
      state_ = std::move(next);
      isPlaced_ = true;
      return true;
    }
    length *= kBacktracking;
  }
  return false;
}

double InverseDesigner::largestStrain(const State& state) const {
  const VectorXd lengths = lateral_.lengthsAt(state.equilibrium.positions);
  return (lengths.array() / state.rest.array() - 1).abs().maxCoeff();
}

/// Than the present state.
bool InverseDesigner::isBetter(const State& trial) const {
  return trial.equilibrium.converged && trial.objective < state_.objective;
}

/// A correction knows nothing of strains: what is beyond their bound must not grow.
bool InverseDesigner::strainsNoMore(const State& trial) const {
  return !options_.maxStrain ||
         largestStrain(trial) <= std::max(*options_.maxStrain, largestStrain(state_));
}

/// Asked last, as the answer is that of the present state from then on.
bool InverseDesigner::staysFirm(const State& trial) {
  return !softness_ || softness_->permits(trial.rest, trial.equilibrium);
}

void InverseDesigner::log(InverseStep::Kind kind, int number) {
  const VectorXd shrink = 1 - state_.rest.array() / printed_.array();
  const long atBound =
      (state_.rest.array() <= low_.array() || state_.rest.array() >= high_.array()).count();
  result_.steps.push_back({kind, number, state_.error.rmsPercent, state_.error.maxPercent,
                           100 * shrink.maxCoeff(), 100 * largestStrain(state_), atBound,
                           std::exchange(cycles_, 0), std::exchange(products_, 0), now() - start_});
  if (options_.onStep) {
    options_.onStep(result_.steps.back());
  }
}

}  // namespace morphgrid
