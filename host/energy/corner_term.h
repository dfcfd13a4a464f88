#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "energy/edges.h"
#include "grid/strut_grid.h"
#include "shared/energy_constants.h"

namespace morphgrid {

/// The angle theta at which a corner rests, in (0, pi).
struct RestAngle {
  double cosine = 0;
  double sine = 1;

  /// That of two arms. Neither vanishes.
  static RestAngle between(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
    const double lengths = a.norm() * b.norm();
    return {a.dot(b) / lengths, a.cross(b).norm() / lengths};
  }
};

/// A corner with arms a, b from its apex, in closed form (docs/method.md, Energy): `w (|a - p|^2 +
/// |b - q|^2)` to the nearest arms p, q at its rest angle. With T = |a|^2 + |b|^2, A = |a x b|, s =
/// a . b sin theta - A cos theta, D = sqrt(T^2 - 4 s^2) that is `2 w s^2 / (T + D) = w (T - D) /
/// 2`.
struct CornerTerm {
  static constexpr int kEdges = 2;
  static constexpr int kVertices = 3;
  using Vectors = EdgeVectors<kEdges>;  ///< One column for the arm a, one for b.

  double weight;        ///< w
  double leastSquare;   ///< kLeastSquare in the unit of length
  RestAngle rest = {};  ///< theta

  template <typename Visit>
  static void forEach(const StrutGrid& grid, Visit visit) {
    const double leastSquare = leastSquareOf(grid);
    forEachCorner(grid.shape, [&](const Corner& corner) {
      const EdgeStencil<kEdges> stencil{{{corner.apex, corner.a}, {corner.apex, corner.b}}};
      const double weight = corner.isLateral ? grid.weights.angle : grid.weights.postAngle;
      CornerTerm term{weight, leastSquare};
      if (corner.isLateral && grid.printedCorners) {
        const Vectors printed = differencesAlong(stencil, *grid.printedCorners);
        term.rest = RestAngle::between(printed.col(0), printed.col(1));
      }
      visit(term, stencil);
    });
  }

  /// The gradient by a is `2 w (a - p) = w (own a + other s_a)`, s_a the derivative of s by a, and
  /// alike for b.
  TermValue<kEdges> evaluate(const Vectors& arms) const {
    const Invariants at = invariantsOf(arms);
    return {2 * weight * at.s * at.s / (at.t + at.d),
            weight * (at.own() * arms + at.other() * at.byArms(arms))};
  }

  /// How the gradient changes when the arms change by z, exactly.
  Vectors hessianProduct(const Vectors& arms, const Vectors& z) const {
    const Invariants at = invariantsOf(arms);
    const Vectors byArms = at.byArms(arms);
    const double changeOfT = 2 * arms.cwiseProduct(z).sum();
    const double changeOfS = byArms.cwiseProduct(z).sum();
    // own' = -2 s turn and other' = t turn, from D D' = T T' - 4 s s'.
    const double turn = 2 * (at.t * changeOfS - at.s * changeOfT) / (at.d * at.d * at.d);
    return weight * (at.own() * z - 2 * at.s * turn * arms + at.t * turn * byArms +
                     at.other() * at.changeOfByArms(arms, z));
  }

  /// `2 w J^T J`, J the derivative of the residual `s sqrt(2 / (T + D))` by a and b:
  /// `J_a = ((T + D) / 2 s_a - s a) / (D sqrt((T + D) / 2))`.
  Eigen::Matrix<double, 6, 6> gaussNewton(const Vectors& arms) const {
    const Invariants at = invariantsOf(arms);
    const double d = std::sqrt(at.d * at.d + kLeastSine2 * at.t * at.t);
    const double h = (at.t + d) / 2;
    const Eigen::Vector<double, 6> j = Vectors(h * at.byArms(arms) - at.s * arms).reshaped();
    return 2 * weight / (d * d * h) * j * j.transpose();
  }

  /// The gradient's derivative by the rest angle: the energy's is `2 w s c / D`, c = a . b cos
  /// theta + A sin theta the derivative of s by theta.
  Vectors gradientByRest(const Vectors& arms) const {
    const Invariants at = invariantsOf(arms);
    const double c = at.product * rest.cosine + at.area * rest.sine;
    const double perArea = rest.sine / at.safeArea;
    const Vectors cByArms =
        crossed(rest.cosine - perArea * at.product, arms) + scaledBySquares(perArea, at, arms);
    const double d3 = at.d * at.d * at.d;
    return 2 * weight *
           (c * (1 / at.d + 4 * at.s * at.s / d3) * at.byArms(arms) -
            2 * at.t * at.s * c / d3 * arms + at.s / at.d * cByArms);
  }

  /// w, for each arm.
  double projectionWeight() const { return weight; }

 private:
  /// Collinear arms have D = 0 and no unique nearest arms; this share of T keeps D above it.
  static constexpr double kCollinear = 1e-12;

  struct Invariants {
    double squareA, squareB, product, area;  ///< |a|^2, |b|^2, a . b, A
    double safeArea;                         ///< A where it divides: never 0.
    double across, along;                    ///< s_a = across b - along |b|^2 a
    double t, s, d;

    double own() const { return -4 * s * s / (d * (t + d)); }
    double other() const { return 2 * s / d; }
    /// s_a and s_b.
    Vectors byArms(const Vectors& arms) const {
      return crossed(across, arms) - scaledBySquares(along, *this, arms);
    }
    /// How they change when the arms change by z.
    Vectors changeOfByArms(const Vectors& arms, const Vectors& z) const {
      const double alongA = arms.col(0).dot(z.col(0));
      const double alongB = arms.col(1).dot(z.col(1));
      const double changeOfProduct = arms.col(0).dot(z.col(1)) + arms.col(1).dot(z.col(0));
      const double growth = (squareB * alongA + squareA * alongB - product * changeOfProduct) /
                            (safeArea * safeArea);  // A' / A
      const double changeOfAlong = -along * growth;
      const double changeOfAcross = changeOfAlong * product + along * changeOfProduct;
      Vectors change = crossed(changeOfAcross, arms) + crossed(across, z) -
                       scaledBySquares(changeOfAlong, *this, arms) -
                       scaledBySquares(along, *this, z);
      change.col(0) -= 2 * along * alongB * arms.col(0);
      change.col(1) -= 2 * along * alongA * arms.col(1);
      return change;
    }
  };

  Invariants invariantsOf(const Vectors& arms) const {
    Invariants at{};
    at.squareA = arms.col(0).squaredNorm();
    at.squareB = arms.col(1).squaredNorm();
    at.product = arms.col(0).dot(arms.col(1));
    at.area = arms.col(0).cross(arms.col(1)).norm();
    at.t = std::max(at.squareA, leastSquare) + std::max(at.squareB, leastSquare);
    at.safeArea = std::max(at.area, double{kLeastSine} * at.t / 2);
    at.along = rest.cosine / at.safeArea;
    at.across = rest.sine + at.along * at.product;
    at.s = at.product * rest.sine - at.area * rest.cosine;
    at.d = std::max(std::sqrt(std::max(at.t * at.t - 4 * at.s * at.s, 0.0)), kCollinear * at.t);
    return at;
  }

  /// factor (b, a)
  static Vectors crossed(double factor, const Vectors& x) { return factor * x.rowwise().reverse(); }
  /// factor (|b|^2 x_a, |a|^2 x_b)
  static Vectors scaledBySquares(double factor, const Invariants& at, const Vectors& x) {
    Vectors result = factor * x;
    result.col(0) *= at.squareB;
    result.col(1) *= at.squareA;
    return result;
  }
};

}  // namespace morphgrid
