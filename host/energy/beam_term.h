#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cmath>

#include "energy/edges.h"
#include "grid/strut_grid.h"

namespace morphgrid {

/// A bar that is welded to joints a and b (docs/method.md, A frame of welded bars): the sum of
/// `stiffness strain^2 / 2` over six strains. Its ends' state is the vector from a to b and the
/// joints' rotations; how they change, a vector of 9: the former, then the turns of a and of b, in
/// space (R <- exp(turn) R).
struct BeamTerm {
  static constexpr int kUnknowns = 9;
  static constexpr int kStrains = 6;
  template <typename Scalar>
  using Vector3 = Eigen::Matrix<Scalar, 3, 1>;
  template <typename Scalar>
  using Vector9 = Eigen::Matrix<Scalar, 9, 1>;
  /// Stretch; bending in the sheet's plane and across; S shapes, alike; twist.
  template <typename Scalar>
  using Strains = Eigen::Matrix<Scalar, 6, 1>;

  /// Directions of the bar at its ends: columns t along it, n in the sheet's plane, b across.
  template <typename Scalar>
  struct Ends {
    Vector3<Scalar> arm;
    Eigen::Matrix<Scalar, 3, 3> a, b;
  };

  struct Value {
    double energy;
    Vector9<double> gradient;
  };

  BarSection section;
  double rest;              ///< Of the flexible part, > 0
  Eigen::Matrix3d printed;  ///< t, n, b as printed.

  /// That of a strut of a grid which has bars.
  static BeamTerm of(const StrutGrid& grid, const Strut& strut) {
    const BarSection& bar = grid.bars->section(strut);
    return {bar, valueAt(grid.rest, strut) - 2 * bar.joint,
            axesOf(printedDirection(*grid.bars, strut), strut.isLateral())};
  }

  /// visit(term, Edge) for all bars of a grid, which has some.
  template <typename Visit>
  static void forEach(const StrutGrid& grid, Visit visit) {
    forEachStrut(grid.shape, [&](const Strut& strut) {
      visit(of(grid, strut), Edge{strut.from, strut.to});
    });
  }

  /// Lateral bars bend about z, posts about y, where they bend in their first plane.
  static Eigen::Matrix3d axesOf(const Eigen::Vector3d& along, bool isLateral) {
    Eigen::Matrix3d axes;
    axes.col(0) = along;
    axes.col(1) =
        isLateral ? Eigen::Vector3d::UnitZ().cross(along) : Eigen::Vector3d::UnitY().cross(along);
    axes.col(1).normalize();
    axes.col(2) = along.cross(axes.col(1));
    return axes;
  }

  Ends<double> endsAt(const Eigen::Vector3d& arm, const Eigen::Quaterniond& a,
                      const Eigen::Quaterniond& b) const {
    return {arm, a.toRotationMatrix() * printed, b.toRotationMatrix() * printed};
  }

  /// Stiffnesses of the strains.
  Strains<double> stiffness() const {
    const double inverse = 12 * section.shearing / (rest * rest);
    const auto shear = [&](double bending) {
      return 3 * bending / (rest * (1 + inverse * bending));
    };
    Strains<double> stiffness;
    stiffness << section.stretching * rest, section.bendingN / rest, section.bendingB / rest,
        shear(section.bendingN), shear(section.bendingB), 4 * section.twisting / rest;
    return stiffness;
  }

  template <typename Scalar>
  Strains<Scalar> strains(const Ends<Scalar>& ends) const {
    using std::sqrt;
    const Vector3<Scalar> chord = ends.arm - section.joint * (ends.a.col(0) + ends.b.col(0)).eval();
    const Scalar length = sqrt(chord.dot(chord));
    const Vector3<Scalar> along = chord / length;
    const auto anglesAt = [&](const Eigen::Matrix<Scalar, 3, 3>& axes) {
      const Scalar f = (1 + 4 / (1 + along.dot(axes.col(0)))) / 3;
      return Eigen::Matrix<Scalar, 2, 1>(f * along.dot(axes.col(1)), f * along.dot(axes.col(2)));
    };
    const Eigen::Matrix<Scalar, 2, 1> atA = anglesAt(ends.a), atB = anglesAt(ends.b);
    const Eigen::Matrix<Scalar, 2, 1> bend = atA - atB, shear = atA + atB;
    const auto& a = ends.a;
    const auto& b = ends.b;
    const Scalar trace = a.col(0).dot(b.col(0)) + a.col(1).dot(b.col(1)) + a.col(2).dot(b.col(2));
    Strains<Scalar> strains;
    strains << length / rest - 1 + (5 * bend.dot(bend) + 3 * shear.dot(shear)) / 120, bend[0],
        bend[1], shear[0], shear[1],
        (a.col(1).dot(b.col(2)) - a.col(2).dot(b.col(1))) / (1 + trace);
    return strains;
  }

  double energy(const Ends<double>& ends) const {
    return strains(ends).cwiseAbs2().dot(stiffness()) / 2;
  }

  Value evaluate(const Ends<double>& ends) const;
  /// How the gradient changes with the ends, exactly: 9 x 9. Symmetric where no joint bears a
  /// moment.
  Eigen::Matrix<double, 9, 9> hessian(const Ends<double>& ends) const;
  /// J^T stiffness J, J the strains' derivatives, and what tension adds against motions across the
  /// bar: symmetric, positive semi-definite.
  Eigen::Matrix<double, 9, 9> gaussNewton(const Ends<double>& ends) const;
  /// The gradient's derivative by the rest length.
  Vector9<double> gradientByRest(const Ends<double>& ends) const;
};

}  // namespace morphgrid
