#pragma once
#include <chrono>
#include <memory>
#include <optional>
#include <vector>

#include "solve/checkpoint_pace.h"
#include "solve/equilibrium.h"
#include "solve/preconditioned_descent.h"

namespace morphgrid {

/// The last steps on one grid: whether the energy has come to rest, and when it will.
class EnergyFall {
 public:
  /// tolerance: of the predicted decrease, as a share of the energy. noEnergy: as good as zero,
  /// where a share of the energy means nothing.
  EnergyFall(double tolerance, double noEnergy) : tolerance_(tolerance), noEnergy_(noEnergy) {}

  void add(const PreconditionedDescent& descent);

  /// How many of the last steps in a row could not have lowered the energy by the tolerance.
  int quietSteps() const { return quietSteps_; }

  /// Whether that many, and more the more steps there were: with weights far apart the energy falls
  /// slowly, and a step says little about what is left.
  bool isQuiet(int steps) const;

  /// Whether the last half of the steps has fallen, and they are enough to tell how fast.
  bool tellsRate() const;
  /// Steps to the tolerance, judged by the last half of them; where these tell a rate.
  double stepsLeft() const;

 private:
  double tolerance_;
  double noEnergy_;
  int quietSteps_ = 0;
  std::vector<double> shares_;
};

/// What has happened since a multigrid solve began. Work is counted in cycles on the finest grid.
class SolveProgress {
 public:
  /// vertexCounts: of the grids, the finest last. Keeps a reference to the options.
  SolveProgress(const SolveOptions& options, const std::vector<int>& vertexCounts);

  double seconds() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  double cycles() const { return cycles_; }
  std::vector<ConvergenceSample>& history() { return history_; }

  /// meanStiffness: see StrutEnergy.
  void beginGrid(std::size_t n, double spacing, double meanStiffness);

  /// Reports which grid is solved now: a coarser one, or none for the grid itself.
  void tellGrid(std::shared_ptr<const DeviceGrid> grid) const;

  /// Energy of the grid begun last that is as good as none, as PreconditionedDescent::energy().
  double noEnergy() const { return noEnergy_; }
  double residualOf(const PreconditionedDescent& descent) const {
    return descent.gradientNorm() * residualScale_;
  }

  /// Takes in a step on the grid begun last and reports it. Throws DeviceError when the energy is
  /// no number.
  void add(const PreconditionedDescent& descent, const EnergyFall& fall);

  std::optional<StopReason> reasonToStop() const;

 private:
  using Clock = std::chrono::steady_clock;

  const SolveOptions& options_;
  CheckpointPace<SolveCheckpoint> pace_;
  Clock::time_point start_ = Clock::now();
  std::vector<double> shares_;  ///< Vertices of a grid over those of the finest.
  std::vector<int> vertexCounts_;
  std::size_t phase_ = 0;  ///< The grid begun last.
  double energyScale_ = 1;
  double residualScale_ = 1;  ///< From a gradient's norm, see StrutEnergy::residual().
  double noEnergy_ = 0;
  double cycles_ = 0;
  double phaseSeconds_ = 0;  ///< When that grid was begun.
  double phaseCycles_ = 0;
  std::vector<ConvergenceSample> history_;
};

}  // namespace morphgrid
