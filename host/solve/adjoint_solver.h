#pragma once
#include "solve/adjoint.h"
#include "solve/preconditioned_descent.h"

namespace morphgrid {

/// Solves H lambda = b on the device, H the exact Hessian of a grid's energy at its equilibrium, by
/// conjugate gradients on one V-cycle: how an equilibrium answers to forces. The right side must
/// hold no rigid motion: those cost no energy.
class AdjointSolver {
 public:
  /// Works with the descent's cycle, and in its vectors while it rests. Keeps references. Throws
  /// DeviceError when the device's limits are exceeded.
  AdjointSolver(const Device& device, PreconditionedDescent& descent);

  /// H at the positions that the descent has reached. rightSide, lambda: 3 x vectorLength, the
  /// unknowns of the device. Throws DeviceError when the device fails.
  Adjoint solve(const Eigen::Matrix3Xd& rightSide, const AdjointOptions& options = {});

 private:
  ComputeKernel dots(const VertexVector& first, const VertexVector& second);
  void recordStart();
  /// One product with H and one cycle.
  void recordStep();
  void recordCycle();
  void recordScalars(const ComputeKernel& dots, std::uint32_t stage);

  const Device& device_;
  PreconditionedDescent& descent_;
  std::uint32_t count_;
  const VertexVector& remainder_;
  const VertexVector& correction_;
  const VertexVector& direction_;
  VertexVector solution_;
  VertexVector product_;
  Buffer sums_;
  Buffer scalars_;
  Hessian::Step multiplication_;
  ComputeKernel directionDots_;
  ComputeKernel remainderDots_;
  ComputeKernel advance_;
  ComputeKernel turn_;
  ComputeKernel updateScalars_;
  CommandStream stream_;
  int usualProducts_ = 1;  ///< So many the last solve took.
};

}  // namespace morphgrid
