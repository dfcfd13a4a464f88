#pragma once
#include <Eigen/Core>

#include "grid/strut_grid.h"

namespace morphgrid {

/// The energy of a grid, the sum of its terms (energy_terms.h), in double precision. It is the
/// oracle for the device, and gives the figures of the report.
class StrutEnergy {
 public:
  struct Value {
    double energy;              ///< In stiffness x the square of the scene's unit of length.
    Eigen::Matrix3Xd gradient;  ///< 3 x vertexCount
  };

  /// Keeps a reference to the grid, which must be valid, see validate().
  explicit StrutEnergy(const StrutGrid& grid);
  explicit StrutEnergy(StrutGrid&&) = delete;

  /// positions: 3 x vertexCount, in the scene's unit of length.
  Value evaluate(const Eigen::Matrix3Xd& positions) const;

  /// Diagonal of the projective-dynamics matrix per vertex: the sum of the projectionWeight()s
  /// of the edges that end at it, > 0.
  const Eigen::VectorXd& constraintWeights() const { return constraintWeights_; }

  /// Twice the mean of constraintWeights().
  double meanStiffness() const { return 2 * constraintWeights_.mean(); }

  /// How many vertices a term of this grid spans at most. The Gauss-Newton Hessian H is a sum of
  /// positive semidefinite matrices on as many vertices each, so with D its 3 x 3 blocks on the
  /// diagonal no eigenvalue of D^-1 H is larger.
  int mostVertices() const { return mostVertices_; }

  /// |gradient| / (mean stiffness x spacing x sqrt(vertexCount)). Independent of the units of
  /// length and weight, and of the size.
  double residual(const Eigen::Matrix3Xd& gradient) const;

 private:
  const StrutGrid& grid_;
  Eigen::VectorXd constraintWeights_;
  int mostVertices_ = 0;
};

}  // namespace morphgrid
