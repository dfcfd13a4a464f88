#pragma once
#include <Eigen/Core>

#include "solve/equilibrium.h"

namespace morphgrid {

/// The rest lengths that inverse design may choose, one a lateral strut, as a vector in the order
/// of forEachLateralStrut(). Vertical struts stay as they are.
class LateralRest {
 public:
  explicit LateralRest(const GridShape& shape) : shape_(shape) {}

  const GridShape& shape() const { return shape_; }
  Eigen::Index size() const { return shape_.lateralStrutCount(); }

  /// The lateral rest lengths of a grid of this shape.
  Eigen::VectorXd of(const StrutGrid& grid) const;
  /// grid.rest with these lengths, one a lateral strut, in place of its own.
  StrutValues replacedIn(const StrutGrid& grid, const Eigen::VectorXd& lengths) const;

  /// Distances of the struts' ends. positions: 3 x vertexCount.
  Eigen::VectorXd lengthsAt(const Eigen::Matrix3Xd& positions) const;

  /// dJ/dL of J(x(L)), x the equilibrium of the grid: `-lambda . (derivative of the energy's
  /// gradient by L)`, H lambda = dJ/dx with H the exact Hessian of the energy (docs/method.md,
  /// Inverse design). lambda: of as many columns as Adjoint's.
  Eigen::VectorXd gradient(const StrutGrid& grid, const Equilibrium& equilibrium,
                           const Eigen::Matrix3Xd& lambda) const;

 private:
  template <typename ValueOf>
  Eigen::VectorXd collect(const ValueOf& valueOf) const;

  GridShape shape_;
};

}  // namespace morphgrid
