#include "solve/exact_hessian.h"

#include <algorithm>
#include <cmath>

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// As in energy.cpp: keeps D above 0 where arms are collinear.
constexpr double kNearlyCollinear = 1e-12;

/// How the gradient at `to` changes when the strut e changes by z; that at `from` is the opposite.
Vector3d strutChange(const Vector3d& e, const Vector3d& z, double rest, double stiffness) {
  const double squaredLength = e.squaredNorm();
  if (squaredLength <= 0) {
    return Vector3d::Zero();
  }
  const double shortening = rest / std::sqrt(squaredLength);
  return 2 * stiffness * ((1 - shortening) * z + shortening * e.dot(z) / squaredLength * e);
}

struct CornerChange {
  Vector3d a;
  Vector3d b;
};

/// How the gradient per w at the ends of a and b changes when the arms change by za and zb.
CornerChange cornerChange(const Vector3d& a, const Vector3d& b, const Vector3d& za,
                          const Vector3d& zb) {
  const double t = a.squaredNorm() + b.squaredNorm();
  if (t <= 0) {
    return {Vector3d::Zero(), Vector3d::Zero()};
  }
  const double s = a.dot(b);
  const double d = std::max(std::sqrt(std::max(t * t - 4 * s * s, 0.0)), kNearlyCollinear * t);
  const double changeOfT = 2 * (a.dot(za) + b.dot(zb));
  const double changeOfS = a.dot(zb) + b.dot(za);
  const double own = -4 * s * s / (d * (t + d));
  const double other = 2 * s / d;
  // own' = -2 s turn and other' = t turn, from D D' = T T' - 4 s s'.
  const double turn = 2 * (t * changeOfS - s * changeOfT) / (d * d * d);
  return {own * za + other * zb + turn * (t * b - 2 * s * a),
          own * zb + other * za + turn * (t * a - 2 * s * b)};
}

}  // namespace

Matrix3Xd ExactHessian::product(const Matrix3Xd& motion) const {
  const Matrix3Xd& x = positions_;
  Matrix3Xd result = Matrix3Xd::Zero(3, x.cols());
  for (const Strut& strut : energy_.struts()) {
    const Vector3d change = strutChange(
        x.col(strut.to) - x.col(strut.from), motion.col(strut.to) - motion.col(strut.from),
        valueAt(grid_.rest, strut), valueAt(grid_.stiffness, strut));
    result.col(strut.to) += change;
    result.col(strut.from) -= change;
  }
  for (const Corner& corner : energy_.corners()) {
    const CornerChange change =
        cornerChange(x.col(corner.a) - x.col(corner.apex), x.col(corner.b) - x.col(corner.apex),
                     motion.col(corner.a) - motion.col(corner.apex),
                     motion.col(corner.b) - motion.col(corner.apex));
    result.col(corner.a) += grid_.angleWeight * change.a;
    result.col(corner.b) += grid_.angleWeight * change.b;
    result.col(corner.apex) -= grid_.angleWeight * (change.a + change.b);
  }
  return result;
}

}  // namespace morphgrid
