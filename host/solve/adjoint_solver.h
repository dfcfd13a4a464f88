#pragma once
#include <Eigen/Core>

#include "solve/v_cycle.h"

namespace morphgrid {

struct AdjointOptions {
  double tolerance = 1e-3;  ///< Bound on |residual| / |right side|, > 0.
  int productLimit = 100;   ///< >= 0
};

/// lambda with H lambda = right side, about.
struct Adjoint {
  Eigen::Matrix3Xd lambda;  ///< 3 x vertexCount, in the unit of the right side over stiffness.
  int products = 0;         ///< With H.
  double residual = 0;      ///< |residual| / |right side|
  bool converged = false;   ///< False too when H is not positive: no minimum, or a free motion.
};

/// Solves H lambda = b on the device, H the exact Hessian of a grid's energy at its equilibrium, by
/// conjugate gradients on one V-cycle: how an equilibrium answers to forces. The right side must
/// hold no rigid motion: those cost no energy.
class AdjointSolver {
 public:
  /// Keeps references. Throws DeviceError when the device's limits are exceeded.
  AdjointSolver(const Device& device, const DeviceGrid& grid);

  /// H at DeviceGrid::positions(). rightSide: 3 x vertexCount. Throws DeviceError when the device
  /// fails.
  Adjoint solve(const Eigen::Matrix3Xd& rightSide, const AdjointOptions& options = {});

 private:
  struct Products {
    double mixed;    ///< first . second
    double squared;  ///< first . first
  };

  ComputeKernel dots(const VertexVector& first, const VertexVector& second);
  void begin(const Eigen::Matrix3Xd& rightSide);
  /// share x the last direction goes into the next one.
  Products multiply(double share);
  Products advance(double share);
  Products run();

  const Device& device_;
  const DeviceGrid& grid_;
  std::uint32_t count_;
  VertexVector solution_;
  VertexVector remainder_;
  VertexVector correction_;
  VertexVector direction_;
  VertexVector product_;
  Buffer sums_;
  VCycle cycle_;
  GridHessian::Step multiplication_;
  ComputeKernel directionDots_;
  ComputeKernel remainderDots_;
  ComputeKernel advance_;
  ComputeKernel turn_;
  CommandStream stream_;
};

}  // namespace morphgrid
