#pragma once
#include <Eigen/Core>

#include "grid/strut_grid.h"

namespace morphgrid {

/// The Hessian of a StrutEnergy, all of it: unlike Gauss-Newton's (GridHessian) it may be
/// indefinite. Matrix-free, in double precision (docs/method.md, Minimum or saddle).
class ExactHessian {
 public:
  /// positions: 3 x vertexCount, in the scene's unit of length. Keeps references.
  ExactHessian(const StrutGrid& grid, const Eigen::Matrix3Xd& positions)
      : grid_(grid), positions_(positions) {}

  /// H z, in the unit of stiffness times that of z. motion: z, 3 x vertexCount.
  Eigen::Matrix3Xd product(const Eigen::Matrix3Xd& motion) const;

 private:
  const StrutGrid& grid_;
  const Eigen::Matrix3Xd& positions_;
};

}  // namespace morphgrid
