#pragma once
#include <Eigen/Core>
#include <vector>

#include "grid/strut_grid.h"

namespace morphgrid {

/// A right angle to be kept: vertex indices of the apex and of the ends of its two arms.
struct Corner {
  int apex;
  int a;
  int b;
};

/// All pairs of perpendicular neighbours, up to 12 per vertex.
std::vector<Corner> listCorners(const GridShape& shape);

/// The energy of a grid in double precision: struts `w c (|e| - L)^2`, corners
/// `w (|a-p|^2 + |b-q|^2) = 2 w s^2 / (T + D)` with s = a.b, T = |a|^2 + |b|^2, D = sqrt(T^2 - 4
/// s^2). It is the oracle for the device, and gives the figures of the report.
class StrutEnergy {
 public:
  struct Value {
    double energy;
    Eigen::Matrix3Xd gradient;  ///< 3 x vertexCount
  };

  /// Keeps a reference to the grid.
  explicit StrutEnergy(const StrutGrid& grid);
  explicit StrutEnergy(StrutGrid&&) = delete;

  /// positions: 3 x vertexCount.
  Value evaluate(const Eigen::Matrix3Xd& positions) const;

  /// Diagonal of the projective-dynamics matrix per vertex: the sum of the weights with which its
  /// constraints pull (strut w c; corner w at an arm, 2 w at the apex), > 0.
  const Eigen::VectorXd& constraintWeights() const { return constraintWeights_; }

  /// Twice the mean of constraintWeights().
  double meanStiffness() const { return 2 * constraintWeights_.mean(); }

  /// |gradient| / (mean stiffness x spacing x sqrt(vertexCount)). Independent of the units of
  /// length and weight, and of the size.
  double residual(const Eigen::Matrix3Xd& gradient) const;

  const std::vector<Strut>& struts() const { return struts_; }
  const std::vector<Corner>& corners() const { return corners_; }

 private:
  const StrutGrid& grid_;
  std::vector<Strut> struts_;
  std::vector<Corner> corners_;
  Eigen::VectorXd constraintWeights_;
};

}  // namespace morphgrid
