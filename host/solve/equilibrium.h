#pragma once
#include <Eigen/Core>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/interrupt.h"
#include "grid/joint_rotations.h"
#include "solve/smallest_eigenvalue.h"

namespace morphgrid {

class DeviceGrid;

enum class StopReason {
  residual,        ///< The residual fell below the tolerance: converged.
  energy,          ///< The energy has no more to lose than the energy tolerance: converged.
  iterationLimit,  ///< The limit came first.
  stagnated,       ///< The residual no longer falls at the precision of the positions.
  interrupted,     ///< The user asked to stop.
  deviceFailure,   ///< The device failed; the positions are the last that are known.
  laidOut,         ///< A flat sheet that no solver left, see layConformally().
};

/// "residual", "energy", "iteration limit", "stagnated", "interrupted", "device
/// failure", "laid out".
std::string toString(StopReason reason);

struct ConvergenceSample {
  long iteration;           ///< Multigrid: V-cycles, those of coarser grids by their share.
  double energy;            ///< In stiffness x the square of the scene's unit of length.
  double residual;          ///< See StrutEnergy::residual().
  double seconds;           ///< Since the stage began.
  double gridShare = 1;     ///< Vertices over those of the grid: below 1 on coarser grids.
  double secondsLeft = -1;  ///< Estimate; negative: unknown.
};

/// Where a solve stands: enough to go on from, in another process too.
struct SolveCheckpoint {
  int phase = 0;               ///< Multigrid: which nested grid; Jacobi: which load step.
  Eigen::Matrix3Xd positions;  ///< 3 x vertexCount of the phase's grid, in the scene's unit.
  JointRotations rotations;    ///< Of the phase's grid, where it is a frame.
  double iterations = 0;       ///< So far, as ConvergenceSample counts them.
  double seconds = 0;          ///< Since the stage began.
  std::vector<ConvergenceSample> history;
};

struct SolveOptions {
  double tolerance = 1e-9;  ///< Bound on the residual, see StrutEnergy::residual(), > 0
  /// Multigrid also stops when so many steps in a row could not have lowered the energy by more
  /// than this share of it; >= 0, 0: never. The predicted decrease varies from step to step.
  double energyTolerance = 1e-9;
  int quietSteps = 3;            ///< >= 1
  long iterationLimit = 200000;  ///< >= 0
  /// Multigrid starts where the device grid's positions are, near the answer, without coarser
  /// grids.
  bool startsNear = false;
  /// Called before onProgress, by methods that keep the positions on the host; may be empty.
  std::function<void(const Eigen::Matrix3Xd&)> onPositions;
  /// Called now and then with the newest sample; may be empty.
  std::function<void(const ConvergenceSample&)> onProgress;
  /// Called with where the solve stands, as often as costs 1 % of its time, and when it has to end
  /// early; may be empty.
  std::function<void(SolveCheckpoint)> onCheckpoint;
  /// Called with each coarser grid that is solved first, and with none when the grid itself begins;
  /// may be empty.
  std::function<void(std::shared_ptr<const DeviceGrid>)> onGrid;
  /// Whether to end early, called often; may be empty: only Ctrl-C counts then.
  std::function<bool()> isCancelled;
  bool stopRequested() const { return interruptRequested() || (isCancelled && isCancelled()); }
  /// Where a solve of the same grid by the same method stood. Iterations and seconds count on from
  /// there.
  std::optional<SolveCheckpoint> resumeFrom;
};

/// Where a grid comes to rest. Energy and residual are recomputed in double from `positions`.
struct Equilibrium {
  Eigen::Matrix3Xd positions;  ///< 3 x vertexCount, in the scene's unit of length.
  JointRotations rotations;    ///< Of a frame.
  long iterations = 0;
  bool converged = false;
  StopReason reason = StopReason::iterationLimit;
  double residual = 0;  ///< See StrutEnergy::residual().
  double energy = 0;    ///< In stiffness x the square of the scene's unit of length.
  double seconds = 0;   ///< Since the stage began.
  std::vector<ConvergenceSample> history;
  std::optional<SmallestEigenvalue> smallestEigenvalue;  ///< On request.
};

/// What the smallest eigenvalue says; undecided without one, and where the solver has not
/// converged: no equilibrium is neither minimum nor saddle.
Verdict verdictOf(const Equilibrium& equilibrium);

}  // namespace morphgrid
