#pragma once
#include "solve/coarse_levels.h"
#include "solve/hessian.h"

namespace morphgrid {

/// One V-cycle of multigrid on the Gauss-Newton Hessian of a grid: about its inverse, symmetric.
/// Lengths in units of the spacing, energies in stiffness x spacing^2.
class VCycle {
 public:
  /// correction = about H^-1 rightSide. Keeps references. Throws DeviceError when the device's
  /// limits are exceeded.
  VCycle(const Device& device, const DeviceGrid& grid, const VertexVector& rightSide,
         const VertexVector& correction);

  /// Takes H at `positions` (as DeviceGrid::positions()), with `damping` times the Laplacian whose
  /// edges weigh 1 added; waits.
  void linearise(const Buffer& positions, double damping = 0);

  void record(CommandStream& stream) const;

  /// The Hessian at the positions of the last linearise().
  Hessian& hessian() { return *hessian_; }

 private:
  VertexVector residual_;
  VertexVector smoothed_;
  std::unique_ptr<Hessian> hessian_;
  CoarseLevels coarse_;
  Hessian::Step firstSmoothing_;
  Hessian::Step computeResidual_;
  Hessian::Step lastSmoothing_;
  CommandStream stream_;
};

}  // namespace morphgrid
