#pragma once
#include <Eigen/SparseCholesky>

#include "grid/strut_grid.h"

namespace morphgrid {

/// M, twice the constant matrix of projective dynamics (Bouaziz et al. 2014), factorised on the
/// host: `x^T M x = 2 sum w |e|^2` over the edges e of all terms, w as projectionWeight(); x, y and
/// z share it. One vertex is held weakly, so that translations have an inverse.
class ConstantMatrix {
 public:
  explicit ConstantMatrix(const StrutGrid& grid);

  /// M^-1 applied to x, y and z each. right and the result: 3 x vertexCount.
  Eigen::Matrix3Xd solve(const Eigen::Matrix3Xd& right) const;

 private:
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
};

}  // namespace morphgrid
