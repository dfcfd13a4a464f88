#pragma once
#include <Eigen/SparseCholesky>

#include "grid/strut_grid.h"

namespace morphgrid {

/// Twice the constant matrix of projective dynamics, factorised on the host; x, y and z share it.
class ConstantMatrix {
 public:
  explicit ConstantMatrix(const StrutGrid& grid);

  /// right: 3 x vertexCount.
  Eigen::Matrix3Xd solve(const Eigen::Matrix3Xd& right) const;

 private:
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
};

}  // namespace morphgrid
