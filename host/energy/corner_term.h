#pragma once
#include <Eigen/Core>
#include <algorithm>
#include <cmath>

#include "energy/edges.h"
#include "grid/strut_grid.h"
#include "shared/energy_constants.h"

namespace morphgrid {

/// A corner with arms a, b from its apex, in closed form (docs/method.md, Energy): `w (|a - p|^2 +
/// |b - q|^2)` to the nearest arms p, q at a right angle. With T = |a|^2 + |b|^2, s = a . b, D =
/// sqrt(T^2 - 4 s^2) that is `2 w s^2 / (T + D) = w (T - D) / 2`.
struct CornerTerm {
  static constexpr int kEdges = 2;
  static constexpr int kVertices = 3;
  using Vectors = EdgeVectors<kEdges>;  ///< One column for the arm a, one for b.

  double weight;       ///< w
  double leastSquare;  ///< kLeastSquare in the unit of length

  template <typename Visit>
  static void forEach(const StrutGrid& grid, Visit visit) {
    const CornerTerm term{grid.weights.angle, leastSquareOf(grid)};
    forEachCorner(grid.shape, [&](const Corner& corner) {
      visit(term, EdgeStencil<kEdges>{{{corner.apex, corner.a}, {corner.apex, corner.b}}});
    });
  }

  /// The gradient by a is `2 w (a - p) = w (own a + other b)`, and alike for b.
  TermValue<kEdges> evaluate(const Vectors& arms) const {
    const Invariants at = invariantsOf(arms);
    return {2 * weight * at.s * at.s / (at.t + at.d),
            mixed(weight * at.own(), arms, weight * at.other(), arms)};
  }

  /// How the gradient changes when the arms change by z, exactly.
  Vectors hessianProduct(const Vectors& arms, const Vectors& z) const {
    const Invariants at = invariantsOf(arms);
    const double changeOfT = 2 * arms.cwiseProduct(z).sum();
    const double changeOfS = arms.col(0).dot(z.col(1)) + arms.col(1).dot(z.col(0));
    // own' = -2 s turn and other' = t turn, from D D' = T T' - 4 s s'.
    const double turn = 2 * (at.t * changeOfS - at.s * changeOfT) / (at.d * at.d * at.d);
    return mixed(weight * at.own(), z, weight * at.other(), z) +
           mixed(-2 * weight * at.s * turn, arms, weight * at.t * turn, arms);
  }

  /// `2 w J^T J`, J the derivative of the residual `s sqrt(2 / (T + D))` by a and b:
  /// `J_a = ((T + D) / 2 b - s a) / (D sqrt((T + D) / 2))`.
  Eigen::Matrix<double, 6, 6> gaussNewton(const Vectors& arms) const {
    const Invariants at = invariantsOf(arms);
    const double d = std::sqrt(at.d * at.d + kLeastSine2 * at.t * at.t);
    const double h = (at.t + d) / 2;
    const Eigen::Vector<double, 6> j = mixed(-at.s, arms, h, arms).reshaped();
    return 2 * weight / (d * d * h) * j * j.transpose();
  }

  /// The gradient's derivative by the rest angle, at 90 degrees. For another angle theta that a and
  /// b, at an angle gamma, shall have, D^2 = |a|^4 + |b|^4 + 2 |a|^2 |b|^2 cos 2 (gamma - theta),
  /// so that the energy's derivative by theta is `2 w s A / D`, A = |a x b|.
  Vectors gradientByRest(const Vectors& arms) const {
    const Invariants at = invariantsOf(arms);
    const double squareA = arms.col(0).squaredNorm();
    const double squareB = arms.col(1).squaredNorm();
    const double area = std::sqrt(std::max(squareA * squareB - at.s * at.s, 0.0));
    const double d3 = at.d * at.d * at.d;
    // A' = (|b|^2 a - s b) / A, D' = (2 T a - 4 s b) / D by a.
    const double byArea = area > 0 ? at.s / (at.d * area) : 0;
    Vectors result = mixed(-2 * at.s * at.t * area / d3, arms,
                           area / at.d + 4 * at.s * at.s * area / d3 - byArea * at.s, arms);
    result.col(0) += byArea * squareB * arms.col(0);
    result.col(1) += byArea * squareA * arms.col(1);
    return 2 * weight * result;
  }

  /// w, for each arm.
  double projectionWeight() const { return weight; }

 private:
  /// Collinear arms have D = 0 and no unique nearest right angle; this share of T keeps D above it.
  static constexpr double kCollinear = 1e-12;

  struct Invariants {
    double t, s, d;
    double own() const { return -4 * s * s / (d * (t + d)); }
    double other() const { return 2 * s / d; }
  };

  Invariants invariantsOf(const Vectors& arms) const {
    const double t = std::max(arms.col(0).squaredNorm(), leastSquare) +
                     std::max(arms.col(1).squaredNorm(), leastSquare);
    const double s = arms.col(0).dot(arms.col(1));
    return {t, s, std::max(std::sqrt(std::max(t * t - 4 * s * s, 0.0)), kCollinear * t)};
  }

  /// own (x_a, x_b) + other (y_b, y_a)
  static Vectors mixed(double own, const Vectors& x, double other, const Vectors& y) {
    Vectors result;
    for (int axis = 0; axis < 3; ++axis) {
      result(axis, 0) = own * x(axis, 0) + other * y(axis, 1);
      result(axis, 1) = own * x(axis, 1) + other * y(axis, 0);
    }
    return result;
  }
};

}  // namespace morphgrid
