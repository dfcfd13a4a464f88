#pragma once
#include <array>

#include "surface/surface.h"

namespace morphgrid {

/// Bicubic Bezier patch, p(u,v) = sum b_i(u) b_j(v) P_ij.
class BezierPatch : public Surface {
 public:
  /// controlPoints[j][i]: rows run along v, columns along u.
  using ControlPoints = std::array<std::array<Eigen::Vector3d, 4>, 4>;

  /// Throws InputError when a coordinate is not finite or the patch has no area.
  explicit BezierPatch(const ControlPoints& controlPoints);

  Eigen::Vector3d point(double u, double v) const override;
  Eigen::Vector3d normal(double u, double v) const override;
  double curvatureAlongU(double u, double v) const override;
  double curvatureAlongV(double u, double v) const override;

  const ControlPoints& controlPoints() const { return controlPoints_; }

 private:
  template <typename Derivative>
  double isolineCurvature(Derivative derivative, double t, const Eigen::Vector3d& normal) const;

  ControlPoints controlPoints_;
  double size_;  ///< Diagonal of the control points' box, > 0.
};

}  // namespace morphgrid
