#pragma once
#include <Eigen/SparseCholesky>

#include "solve/energy.h"

namespace morphgrid {

/// Twice the constant matrix of projective dynamics, factorised on the host; x, y and z share it.
class ConstantMatrix {
 public:
  ConstantMatrix(const StrutGrid& grid, const StrutEnergy& energy);

  /// right: 3 x vertexCount.
  Eigen::Matrix3Xd solve(const Eigen::Matrix3Xd& right) const;

 private:
  Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>> factor_;
};

}  // namespace morphgrid
