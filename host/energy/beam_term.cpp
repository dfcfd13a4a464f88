#include "energy/beam_term.h"

#include <unsupported/Eigen/AutoDiff>

namespace morphgrid {
namespace {

template <typename Scalar>
using Vector3 = BeamTerm::Vector3<Scalar>;
template <typename Scalar>
using Vector9 = BeamTerm::Vector9<Scalar>;

/// A bar's end: theta = s f(c) with c = e . t, s = e . (n, b), and how it changes with e.
template <typename Scalar>
struct End {
  Eigen::Matrix<Scalar, 2, 1> angles;
  Eigen::Matrix<Scalar, 3, 2> byAlong;

  End(const Vector3<Scalar>& along, const Eigen::Matrix<Scalar, 3, 3>& axes) {
    const Scalar inverse = 1 / (1 + along.dot(axes.col(0)));
    const Scalar f = (1 + 4 * inverse) / 3;
    const Scalar slope = -4 * inverse * inverse / 3;
    for (int k = 0; k < 2; ++k) {
      const Vector3<Scalar> axis = axes.col(k + 1);
      const Scalar sine = along.dot(axis);
      angles[k] = f * sine;
      byAlong.col(k) = f * axis + slope * sine * axes.col(0);
    }
  }
};

/// The energy's gradient in closed form, for numbers that carry derivatives too.
template <typename Scalar>
Vector9<Scalar> gradientOf(const BarSection& section, const Scalar& rest,
                           const BeamTerm::Ends<Scalar>& ends) {
  using std::sqrt;
  const Vector3<Scalar> chord = ends.arm - section.joint * (ends.a.col(0) + ends.b.col(0));
  const Scalar length = sqrt(chord.dot(chord));
  const Vector3<Scalar> along = chord / length;
  const End<Scalar> a(along, ends.a), b(along, ends.b);
  Scalar stretch = length / rest - 1;
  for (int k = 0; k < 2; ++k) {
    const Scalar bend = a.angles[k] - b.angles[k], shear = a.angles[k] + b.angles[k];
    stretch += (5 * bend * bend + 3 * shear * shear) / 120;
  }
  const Scalar tension = section.stretching * stretch;
  const Eigen::Vector2d bending(section.bendingN, section.bendingB);
  Vector3<Scalar> byA = Vector3<Scalar>::Zero(), byB = Vector3<Scalar>::Zero();
  for (int k = 0; k < 2; ++k) {
    const Scalar bend = a.angles[k] - b.angles[k], shear = a.angles[k] + b.angles[k];
    const Scalar phi = 12 * section.shearing * bending[k] / (rest * rest);
    const Scalar byBend = (bending[k] / rest + tension * rest / 12) * bend;
    const Scalar byShear = (3 * bending[k] / (rest * (1 + phi)) + tension * rest / 20) * shear;
    byA += (byShear + byBend) * a.byAlong.col(k);
    byB += (byShear - byBend) * b.byAlong.col(k);
  }
  const Vector3<Scalar> both = byA + byB;
  const Vector3<Scalar> force = tension * along + (both - along.dot(both) * along) / length;

  const auto column = [](const auto& axes, int n) { return Vector3<Scalar>(axes.col(n)); };
  const auto crossed = [&](int m, int n) {
    return Vector3<Scalar>(column(ends.a, m).cross(column(ends.b, n)));
  };
  Scalar denominator(1);
  for (int n = 0; n < 3; ++n) {
    denominator += ends.a.col(n).dot(ends.b.col(n));
  }
  const Scalar twist =
      (ends.a.col(1).dot(ends.b.col(2)) - ends.a.col(2).dot(ends.b.col(1))) / denominator;
  const Vector3<Scalar> axes = crossed(0, 0) + crossed(1, 1) + crossed(2, 2);
  const Scalar perTwist = 4 * section.twisting * twist / (rest * denominator);
  const Vector3<Scalar> twisting = perTwist * (crossed(1, 2) - crossed(2, 1) - twist * axes);

  Vector9<Scalar> gradient;
  gradient << force, byA.cross(along) - section.joint * column(ends.a, 0).cross(force) + twisting,
      byB.cross(along) - section.joint * column(ends.b, 0).cross(force) - twisting;
  return gradient;
}

/// By the nine unknowns, and the rest length.
using Derivatives = Eigen::Matrix<double, 10, 1>;
using Number = Eigen::AutoDiffScalar<Derivatives>;

/// The ends, as they change with the unknowns.
BeamTerm::Ends<Number> differentiable(const BeamTerm::Ends<double>& ends) {
  BeamTerm::Ends<Number> result;
  for (int axis = 0; axis < 3; ++axis) {
    result.arm[axis] = Number(ends.arm[axis], 10, axis);
  }
  const auto turning = [](const Eigen::Matrix3d& axes, int firstTurn) {
    Eigen::Matrix<Number, 3, 3> moved;
    for (int n = 0; n < 3; ++n) {
      for (int turn = 0; turn < 3; ++turn) {
        const Eigen::Vector3d change = Eigen::Vector3d::Unit(turn).cross(axes.col(n));
        for (int row = 0; row < 3; ++row) {
          if (turn == 0) {
            moved(row, n) = Number(axes(row, n), Derivatives::Zero());
          }
          moved(row, n).derivatives()[firstTurn + turn] = change[row];
        }
      }
    }
    return moved;
  };
  result.a = turning(ends.a, 3);
  result.b = turning(ends.b, 6);
  return result;
}

Vector9<Number> differentiatedGradient(const BeamTerm& term, const BeamTerm::Ends<double>& ends) {
  return gradientOf<Number>(term.section, Number(term.rest, 10, 9), differentiable(ends));
}

}  // namespace

BeamTerm::Value BeamTerm::evaluate(const Ends<double>& ends) const {
  return {energy(ends), gradientOf<double>(section, rest, ends)};
}

Eigen::Matrix<double, 9, 9> BeamTerm::hessian(const Ends<double>& ends) const {
  const Vector9<Number> gradient = differentiatedGradient(*this, ends);
  Eigen::Matrix<double, 9, 9> hessian;
  for (int row = 0; row < kUnknowns; ++row) {
    hessian.row(row) = gradient[row].derivatives().head<kUnknowns>();
  }
  return hessian;
}

Eigen::Matrix<double, 9, 9> BeamTerm::gaussNewton(const Ends<double>& ends) const {
  const Ends<Number> moving = differentiable(ends);
  const Strains<Number> derived = strains(moving);
  const Strains<double> stiff = stiffness();
  Eigen::Matrix<double, 9, 9> hessian = Eigen::Matrix<double, 9, 9>::Zero();
  for (int n = 0; n < kStrains; ++n) {
    const Eigen::Matrix<double, 9, 1> row = derived[n].derivatives().head<kUnknowns>();
    hessian += stiff[n] * row * row.transpose();
  }
  const Vector3<Number> movingChord =
      moving.arm - section.joint * (moving.a.col(0) + moving.b.col(0));
  Eigen::Matrix<double, 3, 9> byUnknowns;
  Eigen::Vector3d chord;
  for (int axis = 0; axis < 3; ++axis) {
    chord[axis] = movingChord[axis].value();
    byUnknowns.row(axis) = movingChord[axis].derivatives().head<kUnknowns>();
  }
  const double length = chord.norm();
  const Eigen::Vector3d along = chord / length;
  const double tension = section.stretching * std::max(derived[0].value(), 0.0);
  const Eigen::Matrix3d across = Eigen::Matrix3d::Identity() - along * along.transpose();
  return hessian + tension / length * byUnknowns.transpose() * across * byUnknowns;
}

BeamTerm::Vector9<double> BeamTerm::gradientByRest(const Ends<double>& ends) const {
  const Vector9<Number> gradient = differentiatedGradient(*this, ends);
  Vector9<double> result;
  for (int row = 0; row < kUnknowns; ++row) {
    result[row] = gradient[row].derivatives()[kUnknowns];
  }
  return result;
}

}  // namespace morphgrid
