#include "solve/energy.h"

#include <algorithm>
#include <cmath>

namespace morphgrid {
namespace {

using Eigen::Vector3d;

/// Collinear arms have D = 0 and no unique nearest right angle; this share of T keeps D above it.
constexpr double kCollinear = 1e-12;

}  // namespace

std::vector<Corner> listCorners(const GridShape& shape) {
  std::vector<Corner> corners;
  corners.reserve(static_cast<std::size_t>(shape.vertexCount()) * 12);
  const auto inside = [&](int i, int j, int k) {
    return i >= 0 && i < shape.verticesU && j >= 0 && j < shape.verticesV && k >= 0 &&
           k < shape.layers;
  };
  for (int k = 0; k < shape.layers; ++k) {
    for (int j = 0; j < shape.verticesV; ++j) {
      for (int i = 0; i < shape.verticesU; ++i) {
        const int apex = shape.index(i, j, k);
        for (const int s : {-1, 1}) {
          for (const int t : {-1, 1}) {
            const bool u = inside(i + s, j, k);
            if (u && inside(i, j + t, k)) {
              corners.push_back({apex, shape.index(i + s, j, k), shape.index(i, j + t, k)});
            }
            if (u && inside(i, j, k + t)) {
              corners.push_back({apex, shape.index(i + s, j, k), shape.index(i, j, k + t)});
            }
            if (inside(i, j + s, k) && inside(i, j, k + t)) {
              corners.push_back({apex, shape.index(i, j + s, k), shape.index(i, j, k + t)});
            }
          }
        }
      }
    }
  }
  return corners;
}

StrutEnergy::StrutEnergy(const StrutGrid& grid)
    : grid_(grid),
      struts_(listStruts(grid.shape)),
      corners_(listCorners(grid.shape)),
      constraintWeights_(Eigen::VectorXd::Zero(grid.shape.vertexCount())) {
  for (const Strut& strut : struts_) {
    const double stiffness = valueAt(grid.stiffness, strut);
    constraintWeights_[strut.from] += stiffness;
    constraintWeights_[strut.to] += stiffness;
  }
  for (const Corner& corner : corners_) {
    constraintWeights_[corner.apex] += 2 * grid.angleWeight;
    constraintWeights_[corner.a] += grid.angleWeight;
    constraintWeights_[corner.b] += grid.angleWeight;
  }
}

StrutEnergy::Value StrutEnergy::evaluate(const Eigen::Matrix3Xd& x) const {
  Value value{0, Eigen::Matrix3Xd::Zero(3, x.cols())};
  Eigen::Matrix3Xd& gradient = value.gradient;
  for (const Strut& strut : struts_) {
    const Vector3d e = x.col(strut.to) - x.col(strut.from);
    const double length = e.norm();
    const double excess = length - valueAt(grid_.rest, strut);
    const double stiffness = valueAt(grid_.stiffness, strut);
    value.energy += stiffness * excess * excess;
    if (length > 0) {
      const Vector3d force = 2 * stiffness * excess / length * e;
      gradient.col(strut.to) += force;
      gradient.col(strut.from) -= force;
    }
  }
  for (const Corner& corner : corners_) {
    const Vector3d a = x.col(corner.a) - x.col(corner.apex);
    const Vector3d b = x.col(corner.b) - x.col(corner.apex);
    const double t = a.squaredNorm() + b.squaredNorm();
    const double s = a.dot(b);
    const double d = std::max(std::sqrt(std::max(t * t - 4 * s * s, 0.0)), kCollinear * t);
    if (t <= 0) {
      continue;
    }
    value.energy += 2 * grid_.angleWeight * s * s / (t + d);
    // 2 w (a - p), with p the arm turned to the nearest right angle.
    const double own = -4 * s * s / (d * (t + d));
    const double other = 2 * s / d;
    const Vector3d forceA = grid_.angleWeight * (own * a + other * b);
    const Vector3d forceB = grid_.angleWeight * (own * b + other * a);
    gradient.col(corner.a) += forceA;
    gradient.col(corner.b) += forceB;
    gradient.col(corner.apex) -= forceA + forceB;
  }
  return value;
}

double StrutEnergy::residual(const Eigen::Matrix3Xd& gradient) const {
  return gradient.norm() / (meanStiffness() * grid_.spacing * std::sqrt(double(gradient.cols())));
}

}  // namespace morphgrid
