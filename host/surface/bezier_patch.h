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
  Eigen::ArrayXd curvaturesAlongU(const Eigen::ArrayXd& u, double v) const override;
  Eigen::ArrayXd curvaturesAlongV(double u, const Eigen::ArrayXd& v) const override;

  const ControlPoints& controlPoints() const { return controlPoints_; }

 private:
  struct Isoline;

  Isoline isolineAlongU(double v) const;
  Isoline isolineAlongV(double u) const;
  /// Whether the product of the tangents along u and v tells a normal.
  bool hasArea(const Eigen::Vector3d& cross) const;
  template <typename NormalOf>
  double curvatureAt(const Isoline& line, double t, const NormalOf& normalOf) const;

  ControlPoints controlPoints_;
  double size_;  ///< Diagonal of the control points' box, > 0.
};

}  // namespace morphgrid
