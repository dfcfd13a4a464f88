#pragma once
#include <Eigen/Core>

namespace morphgrid {

struct AdjointOptions {
  double tolerance = 1e-3;  ///< Bound on |residual| / |right side|, > 0.
  int productLimit = 100;   ///< >= 0
};

/// lambda with H lambda = right side, about.
struct Adjoint {
  /// 3 x vertexCount, in the unit of the right side over stiffness; of a frame 3 x 2 vertexCount:
  /// displacements, then turns, in that unit over length.
  Eigen::Matrix3Xd lambda;
  int products = 0;        ///< Products with H.
  double residual = 0;     ///< |residual| / |right side|
  bool converged = false;  ///< False too when H is not positive: no minimum, or a free motion.
};

}  // namespace morphgrid
