#pragma once
#include <memory>
#include <optional>

#include "solve/adjoint.h"
#include "solve/device_grid.h"
#include "solve/equilibrium.h"
#include "solve/nested_grids.h"
#include "solve/smallest_eigenvalue.h"

namespace morphgrid {

class AdjointSolver;
class PreconditionedDescent;
class SolveProgress;
class GridEnergy;

/// L-BFGS on the device whose initial inverse Hessian is a V-cycle of multigrid on the Gauss-Newton
/// Hessian. It owns a grid, on the host and on the device, and keeps what it has allocated while
/// rest lengths, weights and positions change: another solve costs its cycles and no more. Where a
/// solve starts flat, problems of fewer nodes are solved first and start the finer ones; these are
/// freed again, since grids that have changed start near.
class MultigridSolver {
 public:
  /// deviceGrid holds the grid. Nothing is allocated before it is needed.
  MultigridSolver(const Device& device, StrutGrid grid, std::shared_ptr<DeviceGrid> deviceGrid);
  MultigridSolver(const Device& device, const StrutGrid& grid);
  ~MultigridSolver();
  MultigridSolver(const MultigridSolver&) = delete;

  /// The grid with the rest lengths that were set last; its positions are those where the stage
  /// began.
  const StrutGrid& grid() const { return grid_; }
  const std::shared_ptr<DeviceGrid>& onDevice() const { return deviceGrid_; }

  void setRest(const StrutValues& rest);
  /// Another grid of the same shape and kind: what comes of it is what a new solver would give.
  /// Throws InputError when it is not valid.
  void setGrid(StrutGrid grid);
  /// positions: 3 x vertexCount, in the scene's unit of length; where SolveOptions::startsNear
  /// starts, and where adjoints are taken.
  void moveTo(const Eigen::Matrix3Xd& positions);
  /// With the rotations of a frame's joints; else they turn as their bars do in the mean.
  void moveTo(const Eigen::Matrix3Xd& positions, const JointRotations& rotations);

  /// onDevice() holds the solution afterwards. Iterations are V-cycles, those of coarser grids
  /// counted by their share of the vertices. Throws DeviceError when the device fails, InputError
  /// when the checkpoint to resume from is of another grid.
  Equilibrium solve(const SolveOptions& options);

  /// H lambda = rightSide at the present positions, see AdjointSolver. rightSide: 3 x vertexCount,
  /// forces; no moments.
  Adjoint solveAdjoint(const Eigen::Matrix3Xd& rightSide, const AdjointOptions& options = {});

  /// One V-cycle at the present positions, for as long as they stay and the solver lives.
  Preconditioner preconditioner();

 private:
  PreconditionedDescent& descent();
  /// Where the finest grid starts: the nested ones are solved, those that the checkpoint leaves.
  Eigen::Matrix3Xd solveNested(const std::vector<NestedGrid>& grids,
                               const std::optional<SolveCheckpoint>& from,
                               SolveProgress& progress) const;
  /// Positions of a coarser grid's equilibrium, about.
  Eigen::Matrix3Xd solveCoarse(const StrutGrid& grid, SolveProgress& progress) const;
  StopReason solveFinest(std::size_t phase, const SolveOptions& options, SolveProgress& progress);
  /// Energy and residual of the present positions, in double precision on the host.
  Equilibrium assess(StopReason reason, const SolveOptions& options) const;
  /// Where the device stands, with figures as it saw them: nobody who has asked to stop waits for
  /// others.
  Equilibrium leave(const ConvergenceSample& last) const;

  const Device& device_;
  StrutGrid grid_;
  std::unique_ptr<GridEnergy> energy_;  ///< The energy of grid_.
  std::shared_ptr<DeviceGrid> deviceGrid_;
  std::unique_ptr<PreconditionedDescent> descent_;
  std::unique_ptr<AdjointSolver> adjoint_;
};

/// Solves with a solver made for this one call; deviceGrid holds the grid, and the solution
/// afterwards.
Equilibrium solveMultigrid(const Device& device, const StrutGrid& grid, DeviceGrid& deviceGrid,
                           const SolveOptions& options);

/// What a checkpoint of such a solve says about the positions of `grid`, 3 x vertexCount: those of
/// a coarser grid are prolonged. Throws InputError when it is of another grid.
Eigen::Matrix3Xd finestPositions(const StrutGrid& grid, const SolveCheckpoint& checkpoint);

}  // namespace morphgrid
