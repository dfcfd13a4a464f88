#include "solve/solve_progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "solve/energy_left.h"

namespace morphgrid {
namespace {

// Half of the steps must be as many for their fall to tell a rate.
constexpr std::size_t kFewestSteps = 2;
// Of all steps on a grid, those that must be quiet before it ends.
constexpr double kQuietShare = 0.05;

}  // namespace

void EnergyFall::add(const PreconditionedDescent& descent) {
  // Weights may have made it negative.
  const double energy = std::abs(descent.energy());
  const double share = energy > noEnergy_ ? descent.predictedDecrease() / energy : 0;
  quietSteps_ = share < tolerance_ ? quietSteps_ + 1 : 0;
  shares_.push_back(share);
}

bool EnergyFall::isQuiet(int steps) const {
  return quietSteps_ >= std::max(double(steps), kQuietShare * double(shares_.size()));
}

bool EnergyFall::tellsRate() const {
  const std::size_t span = shares_.size() / 2;
  return span >= kFewestSteps && tolerance_ > 0 && shares_.back() > 0 &&
         shares_[shares_.size() - 1 - span] > shares_.back();
}

double EnergyFall::stepsLeft() const {
  const std::size_t span = shares_.size() / 2;
  const double now = shares_.back();
  const double fall = std::log(shares_[shares_.size() - 1 - span] / now);
  return std::max(0.0, std::log(now / tolerance_)) * double(span) / fall;
}

SolveProgress::SolveProgress(const SolveOptions& options, const std::vector<int>& vertexCounts)
    : options_(options), pace_(options.onCheckpoint), vertexCounts_(vertexCounts) {
  if (const auto& from = options.resumeFrom) {
    phase_ = static_cast<std::size_t>(from->phase);
    cycles_ = from->iterations;
    start_ -=
        std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(from->seconds));
    history_ = from->history;
  }
  for (const int count : vertexCounts) {
    shares_.push_back(double(count) / vertexCounts.back());
  }
}

void SolveProgress::beginGrid(std::size_t n, double spacing, double meanStiffness) {
  const double count = vertexCounts_[n];
  phase_ = n;
  phaseSeconds_ = seconds();
  phaseCycles_ = cycles_;
  energyScale_ = spacing * spacing;
  residualScale_ = 1 / (meanStiffness * std::sqrt(count));
  noEnergy_ = negligibleEnergy(meanStiffness, count);
}

void SolveProgress::tellGrid(std::shared_ptr<const DeviceGrid> grid) const {
  if (options_.onGrid) {
    options_.onGrid(std::move(grid));
  }
}

void SolveProgress::add(const PreconditionedDescent& descent, const EnergyFall& fall) {
  const double share = shares_[phase_];
  cycles_ += share;
  const double residual = residualOf(descent);
  if (!std::isfinite(descent.energy()) || !std::isfinite(residual)) {
    throw DeviceError(
        fmt::format("the solve left the range of numbers at cycle {:.0f}; weights, or lengths, "
                    "that differ less may do",
                    cycles_));
  }
  // Before, what a cycle takes and how many are left is hardly known.
  const bool isKnown = phase_ + 1 == shares_.size() && fall.tellsRate();
  const double rate = (seconds() - phaseSeconds_) / (cycles_ - phaseCycles_);
  history_.push_back({static_cast<long>(std::ceil(cycles_)), descent.energy() * energyScale_,
                      residual, seconds(), share, isKnown ? rate * fall.stepsLeft() : -1});
  if (options_.onProgress) {
    options_.onProgress(history_.back());
  }
  const int phase = static_cast<int>(phase_);
  pace_.offer(phase, reasonToStop().has_value(), [&] {
    return SolveCheckpoint{phase,   descent.positions(), descent.rotations(),
                           cycles_, seconds(),           history_};
  });
}

std::optional<StopReason> SolveProgress::reasonToStop() const {
  if (options_.stopRequested()) {
    return StopReason::interrupted;
  }
  if (cycles_ >= static_cast<double>(options_.iterationLimit)) {
    return StopReason::iterationLimit;
  }
  return std::nullopt;
}

}  // namespace morphgrid
