#pragma once
#include <array>

#include "surface/surface.h"

namespace morphgrid {

/// Bicubic Bezier patch, p(u,v) = sum b_i(u) b_j(v) P_ij.
class BezierPatch : public Surface {
 public:
  /// controlPoints[j][i]: rows run along v, columns along u.
  using ControlPoints = std::array<std::array<Eigen::Vector3d, 4>, 4>;

  /// Throws InputError when a coordinate is not finite or all points coincide.
  explicit BezierPatch(const ControlPoints& controlPoints);

  Eigen::Vector3d point(double u, double v) const override;
  Eigen::Vector3d normal(double u, double v) const override;
  IsolineCurvature curvature(double u, double v) const override;

  const ControlPoints& controlPoints() const { return controlPoints_; }

 private:
  struct Derivatives {
    Eigen::Vector3d u, v, uu, vv;
  };
  Derivatives derivatives(double u, double v) const;
  Eigen::Vector3d normalFrom(const Derivatives& d, double u, double v) const;

  ControlPoints controlPoints_;
  double size_;  ///< Diagonal of the control points' box, > 0.
};

}  // namespace morphgrid
