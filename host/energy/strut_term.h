#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "energy/edges.h"
#include "grid/strut_grid.h"
#include "shared/energy_constants.h"

namespace morphgrid {

/// A strut with edge e and rest length L: `w c (|e| - L)^2` (docs/method.md, Energy); l = |e|,
/// n = e / l. Lengths are in the grid's unit, w c is energy over length squared.
struct StrutTerm {
  static constexpr int kEdges = 1;
  static constexpr int kVertices = 2;
  using Vectors = EdgeVectors<kEdges>;

  double stiffness;    ///< w c
  double restLength;   ///< L, > 0
  double leastSquare;  ///< kLeastSquare in the unit of length

  static StrutTerm of(const StrutGrid& grid, const Strut& strut) {
    return {valueAt(grid.stiffness, strut), valueAt(grid.rest, strut), leastSquareOf(grid)};
  }
  static EdgeStencil<kEdges> stencilOf(const Strut& strut) { return {{{strut.from, strut.to}}}; }

  template <typename Visit>
  static void forEach(const StrutGrid& grid, Visit visit) {
    forEachStrut(grid.shape, [&](const Strut& strut) { visit(of(grid, strut), stencilOf(strut)); });
  }

  /// The gradient is `2 w c (l - L) n`.
  TermValue<kEdges> evaluate(const Vectors& e) const {
    const double l = length(e);
    const double excess = l - restLength;
    return {stiffness * excess * excess, 2 * stiffness * excess / l * e};
  }

  /// `2 w c ((1 - L / l) z + L / l n n^T z)`
  Vectors hessianProduct(const Vectors& e, const Vectors& z) const {
    const double l = length(e);
    const double share = restLength / l;
    return 2 * stiffness * ((1 - share) * z + share * e.dot(z) / (l * l) * e);
  }

  /// `2 w c (n n^T + max(0, 1 - L / l) (I - n n^T))`: without what compression takes away.
  Eigen::Matrix3d gaussNewton(const Vectors& e) const {
    const double l = length(e);
    const Eigen::Matrix3d along = e * e.transpose() / (l * l);
    const double stretch = std::max(0.0, 1 - restLength / l);
    return 2 * stiffness * (along + stretch * (Eigen::Matrix3d::Identity() - along));
  }

  /// The gradient's derivative by the rest length L: `-2 w c n`, n the unit vector along e.
  Vectors gradientByRest(const Vectors& e) const { return -2 * stiffness / length(e) * e; }

  /// w c
  double projectionWeight() const { return stiffness; }

 private:
  double length(const Vectors& e) const {
    return std::sqrt(std::max(e.squaredNorm(), leastSquare));
  }
};

}  // namespace morphgrid
