#include "surface/bezier_patch.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/number_range.h"

namespace morphgrid {
namespace {

using Eigen::Vector3d;
using Eigen::Vector4d;

Vector4d bernstein(double t) {
  const double s = 1 - t;
  return {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
}

Vector4d bernsteinFirst(double t) {
  const double s = 1 - t;
  return {-3 * s * s, 3 * s * s - 6 * s * t, 6 * s * t - 3 * t * t, 3 * t * t};
}

Vector4d bernsteinSecond(double t) {
  const double s = 1 - t;
  return {6 * s, 6 * (t - 2 * s), 6 * (s - 2 * t), 6 * t};
}

Vector3d combine(const BezierPatch::ControlPoints& points, const Vector4d& alongU,
                 const Vector4d& alongV) {
  Vector3d sum = Vector3d::Zero();
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      sum += alongU[i] * alongV[j] * points[j][i];
    }
  }
  return sum;
}

/// Lengths and areas below this share of the patch's size count as vanished.
constexpr double kDegenerate = 1e-9;

/// Bends by less than this angle over the patch's size are rounding: the isoline is straight.
constexpr double kFlat = 1e-12;

/// Where a tangent vanishes (collapsed edge, coincident control points) the frame is taken this
/// share of the way to the centre.
constexpr double kInward = 1e-3;

double inward(double t) { return t + kInward * (0.5 - t); }

double signedCurvature(const Vector3d& first, const Vector3d& second, const Vector3d& normal,
                       double size) {
  const double speed = first.norm();
  if (speed <= kDegenerate * size) {
    return 0;  // The isoline is a point: it has no direction to bend in.
  }
  const double curvature = first.cross(second).norm() / (speed * speed * speed);
  if (curvature * size < kFlat) {
    return 0;
  }
  return normal.dot(second) >= 0 ? curvature : -curvature;
}

bool isWithin(const NumberRange& range, const Vector3d& point) {
  return std::all_of(point.begin(), point.end(), [&](double x) { return range.contains(x); });
}

}  // namespace

BezierPatch::BezierPatch(const ControlPoints& controlPoints) : controlPoints_(controlPoints) {
  Vector3d low = controlPoints[0][0];
  Vector3d high = low;
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      const Vector3d& p = controlPoints[j][i];
      if (!isWithin(kCoordinates, p)) {
        throw InputError(fmt::format(
            "control point (row {}, column {}): each coordinate must be {}, got [{}, {}, {}]", j, i,
            describe(kCoordinates), p.x(), p.y(), p.z()));
      }
      low = low.cwiseMin(p);
      high = high.cwiseMax(p);
    }
  }
  size_ = (high - low).norm();

  double largestArea = 0;
  constexpr int kProbes = 8;
  for (int a = 0; a <= kProbes; ++a) {
    for (int b = 0; b <= kProbes; ++b) {
      const double u = double(a) / kProbes;
      const double v = double(b) / kProbes;
      const Vector3d alongU = combine(controlPoints_, bernsteinFirst(u), bernstein(v));
      const Vector3d alongV = combine(controlPoints_, bernstein(u), bernsteinFirst(v));
      largestArea = std::max(largestArea, alongU.cross(alongV).norm());
    }
  }
  if (!(largestArea > kDegenerate * size_ * size_)) {
    throw InputError(
        "the patch has no area: its control points coincide or lie on a line; a surface needs "
        "points "
        "that span one");
  }
}

Vector3d BezierPatch::point(double u, double v) const {
  return combine(controlPoints_, bernstein(u), bernstein(v));
}

bool BezierPatch::hasArea(const Vector3d& cross) const {
  return cross.norm() > kDegenerate * size_ * size_;
}

Vector3d BezierPatch::normal(double u, double v) const {
  // A second try further inside finds the frame that a collapsed edge or corner lacks.
  for (int attempt = 0; attempt < 2; ++attempt) {
    const Vector3d alongU = combine(controlPoints_, bernsteinFirst(u), bernstein(v));
    const Vector3d alongV = combine(controlPoints_, bernstein(u), bernsteinFirst(v));
    const Vector3d cross = alongU.cross(alongV);
    if (hasArea(cross)) {
      return cross.normalized();
    }
    u = inward(u);
    v = inward(v);
  }
  return Vector3d::UnitZ();
}

/// An isoline as a cubic in the parameter along it, and the patch's derivative across it.
struct BezierPatch::Isoline {
  Eigen::Matrix<double, 3, 4> points;
  Eigen::Matrix<double, 3, 4> across;
};

BezierPatch::Isoline BezierPatch::isolineAlongU(double v) const {
  const Vector4d basis = bernstein(v);
  const Vector4d basisAcross = bernsteinFirst(v);
  Isoline line{Eigen::Matrix<double, 3, 4>::Zero(), Eigen::Matrix<double, 3, 4>::Zero()};
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      line.points.col(i) += basis[j] * controlPoints_[j][i];
      line.across.col(i) += basisAcross[j] * controlPoints_[j][i];
    }
  }
  return line;
}

BezierPatch::Isoline BezierPatch::isolineAlongV(double u) const {
  const Vector4d basis = bernstein(u);
  const Vector4d basisAcross = bernsteinFirst(u);
  Isoline line{Eigen::Matrix<double, 3, 4>::Zero(), Eigen::Matrix<double, 3, 4>::Zero()};
  for (int j = 0; j < 4; ++j) {
    for (int i = 0; i < 4; ++i) {
      line.points.col(j) += basis[i] * controlPoints_[j][i];
      line.across.col(j) += basisAcross[i] * controlPoints_[j][i];
    }
  }
  return line;
}

/// normalOf(first): the patch's normal at t, where the isoline has that first derivative.
template <typename NormalOf>
double BezierPatch::curvatureAt(const Isoline& line, double t, const NormalOf& normalOf) const {
  Vector3d first = line.points * bernsteinFirst(t);
  const Vector3d normal = normalOf(first);
  if (first.norm() <= kDegenerate * size_) {
    t = inward(t);
    first = line.points * bernsteinFirst(t);
  }
  return signedCurvature(first, line.points * bernsteinSecond(t), normal, size_);
}

Eigen::ArrayXd BezierPatch::curvaturesAlongU(const Eigen::ArrayXd& u, double v) const {
  const Isoline line = isolineAlongU(v);
  return u.unaryExpr([&](double t) {
    return curvatureAt(line, t, [&](const Vector3d& first) {
      const Vector3d cross = first.cross(line.across * bernstein(t));
      return hasArea(cross) ? cross.normalized() : normal(t, v);
    });
  });
}

Eigen::ArrayXd BezierPatch::curvaturesAlongV(double u, const Eigen::ArrayXd& v) const {
  const Isoline line = isolineAlongV(u);
  return v.unaryExpr([&](double t) {
    return curvatureAt(line, t, [&](const Vector3d& first) {
      const Vector3d cross = Vector3d(line.across * bernstein(t)).cross(first);
      return hasArea(cross) ? cross.normalized() : normal(u, t);
    });
  });
}

}  // namespace morphgrid
