#pragma once
#include <optional>

#include "energy/strut_energy.h"
#include "gpu/command_stream.h"
#include "solve/column_walk.h"
#include "solve/equilibrium.h"

namespace morphgrid {

/// Jacobi-style projective dynamics on the device: every strut and corner is projected, every
/// vertex takes the weighted mean of what its constraints want; Chebyshev acceleration that
/// restarts where it leads uphill. The rest lengths are loaded in steps from the initial lengths to
/// the designed ones, so that the grid bends as a whole and not region by region.
class JacobiSolver {
 public:
  /// Keeps references; the device grid holds the newest state before, during and after solve().
  JacobiSolver(const Device& device, const StrutGrid& grid, DeviceGrid& deviceGrid);

  /// Throws DeviceError when the device fails, InputError when the checkpoint to resume from is of
  /// another grid.
  Equilibrium solve(const SolveOptions& options);

  /// Runs `count` sweeps on the state as it is, the first without momentum, and waits: for the
  /// benchmark and tests. `precise` asks for a device with float64.
  void sweep(int count, bool precise = false);

 private:
  class RunLog;

  /// The three kernels that alternate between the two position buffers.
  struct SweepKernels {
    ComputeKernel even;      ///< positions -> previous positions
    ComputeKernel odd;       ///< previous positions -> positions
    ComputeKernel measured;  ///< as odd, with energy and residual
    ColumnWalk walk;
  };

  SweepKernels sweepKernels(ShaderCode spirv, const ColumnWalk& walk) const;
  /// The kernels in double precision, for devices with float64.
  const SweepKernels& preciseSweeps();
  void record(const SweepKernels& kernels, int sweeps);
  void resetState(double tolerance);
  /// Uploads a checkpoint's positions, if there is one; returns the load step to begin with.
  int start(const std::optional<SolveCheckpoint>& from);
  void runUntil(const SweepKernels& kernels, double tolerance, long sweepLimit, RunLog& log);

  const Device& device_;
  const StrutGrid& grid_;
  DeviceGrid& deviceGrid_;
  StrutEnergy energy_;
  ColumnWalk walk_;
  Buffer state_;
  Buffer partials_;
  Buffer samples_;
  TexelView positionsView_;
  TexelView previousView_;
  GridTexels texels_;
  SweepKernels sweeps_;
  std::optional<SweepKernels> preciseSweeps_;  ///< Compiled when they are first needed.
  ComputeKernel control_;
  CommandStream stream_;
};

}  // namespace morphgrid
