#pragma once
#include <optional>

#include "gpu/command_stream.h"
#include "solve/device_grid.h"
#include "solve/energy.h"
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

  /// Throws DeviceError when the device fails.
  Equilibrium solve(const SolveOptions& options);

  /// Runs `checks` x kSweepsPerCheck sweeps on the state as it is and waits: for the benchmark.
  void sweep(int checks, bool precise = false);

 private:
  class RunLog;

  /// The three kernels that alternate between the two position buffers.
  struct SweepKernels {
    ComputeKernel even;      ///< positions -> previous positions
    ComputeKernel odd;       ///< previous positions -> positions
    ComputeKernel measured;  ///< as odd, with energy and residual
  };

  SweepKernels sweepKernels(std::span<const std::uint32_t> spirv) const;
  void recordSweep(const ComputeKernel& kernel, std::uint32_t sweep);
  void record(const SweepKernels& kernels, int checks);
  void resetState(double tolerance);
  void runUntil(const SweepKernels& kernels, double tolerance, long sweepLimit, RunLog& log);

  const Device& device_;
  const StrutGrid& grid_;
  DeviceGrid& deviceGrid_;
  StrutEnergy energy_;
  std::uint32_t groupsU_;
  std::uint32_t groupsV_;
  Buffer state_;
  Buffer partials_;
  Buffer samples_;
  TexelView positionsView_;
  TexelView previousView_;
  TexelView restView_;
  TexelView stiffnessView_;
  SweepKernels sweeps_;
  std::optional<SweepKernels> preciseSweeps_;  ///< Where the device computes in double precision.
  ComputeKernel control_;
  CommandStream stream_;
};

}  // namespace morphgrid
