#pragma once
#include <Eigen/Core>
#include <string>

namespace morphgrid {

/// Signed curvature of the two isolines through a point, in 1 / length.
/// Positive where the isoline curves towards the surface normal p_u x p_v.
struct IsolineCurvature {
  double alongU;
  double alongV;
};

/// A target surface over the unit square of parameters (u, v).
class Surface {
 public:
  virtual ~Surface() = default;

  virtual Eigen::Vector3d point(double u, double v) const = 0;

  /// Unit normal, p_u x p_v normalised; finite everywhere.
  virtual Eigen::Vector3d normal(double u, double v) const = 0;

  /// kappa = S |Q' x Q''| / |Q'|^3 with S = sgn(N . Q''), finite everywhere.
  virtual IsolineCurvature curvature(double u, double v) const = 0;
};

}  // namespace morphgrid
