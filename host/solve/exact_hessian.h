#pragma once
#include "solve/energy.h"

namespace morphgrid {

/// The Hessian of a StrutEnergy, all of it: unlike Gauss-Newton's (GridHessian) it may be
/// indefinite. Matrix-free, in double precision.
///
/// strut: `2 c (n n^T + (1 - L / l) (I - n n^T))`; corner: the derivative of its gradient
/// `w (-4 s^2 / (D (T + D)) a + 2 s / D b)` (docs/method.md, Energy).
class ExactHessian {
 public:
  /// positions: 3 x vertexCount, in the scene's unit of length. Keeps references.
  ExactHessian(const StrutGrid& grid, const StrutEnergy& energy, const Eigen::Matrix3Xd& positions)
      : grid_(grid), energy_(energy), positions_(positions) {}

  /// H z, in the unit of stiffness times that of z. motion: z, 3 x vertexCount.
  Eigen::Matrix3Xd product(const Eigen::Matrix3Xd& motion) const;

 private:
  const StrutGrid& grid_;
  const StrutEnergy& energy_;
  const Eigen::Matrix3Xd& positions_;
};

}  // namespace morphgrid
