#pragma once
#include <Eigen/Core>

#include "grid/strut_grid.h"

namespace morphgrid {

/// Double-precision energy of design/method: struts `w c (|e| - L)^2`, corners `2 w s^2 / (T + D)`.
struct EnergyAndGradient {
  double energy;
  Eigen::Matrix3Xd gradient;  ///< 3 x vertexCount
};

double computeEnergy(const StrutGrid& grid, const Eigen::Matrix3Xd& positions);
EnergyAndGradient computeEnergyAndGradient(const StrutGrid& grid, const Eigen::Matrix3Xd& positions);

/// Diagonal of the projective-dynamics matrix per vertex: the sum over its constraints of the weight
/// with which each pulls (strut w c; corner w at an arm, 2 w at the apex). Positive.
Eigen::VectorXd constraintWeights(const StrutGrid& grid);

/// |gradient| / (mean stiffness x spacing x sqrt(vertexCount)), the mean stiffness being twice the mean of
/// constraintWeights(): independent of the unit of length, of the weights' unit and of the size.
double computeResidual(const StrutGrid& grid, const Eigen::Matrix3Xd& gradient);

/// Mean over all corners of |angle - 90| / 90, in percent.
double meanAngleErrorPercent(const GridShape& shape, const Eigen::Matrix3Xd& positions);

}  // namespace morphgrid
