#pragma once
#include <Eigen/Core>

namespace morphgrid {

/// A target surface over the unit square of parameters (u, v).
class Surface {
 public:
  virtual ~Surface() = default;

  virtual Eigen::Vector3d point(double u, double v) const = 0;

  /// Unit normal, p_u x p_v normalised; finite everywhere.
  virtual Eigen::Vector3d normal(double u, double v) const = 0;

  /// Signed curvatures of the isoline along u (v fixed) at each u, in 1 / length, finite
  /// everywhere: S |Q' x Q''| / |Q'|^3 with S = sgn(N . Q''), positive where it curves towards the
  /// normal.
  virtual Eigen::ArrayXd curvaturesAlongU(const Eigen::ArrayXd& u, double v) const = 0;
  virtual Eigen::ArrayXd curvaturesAlongV(double u, const Eigen::ArrayXd& v) const = 0;

  double curvatureAlongU(double u, double v) const {
    return curvaturesAlongU(Eigen::ArrayXd::Constant(1, u), v)[0];
  }
  double curvatureAlongV(double u, double v) const {
    return curvaturesAlongV(u, Eigen::ArrayXd::Constant(1, v))[0];
  }
};

}  // namespace morphgrid
