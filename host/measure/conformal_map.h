#pragma once
#include <Eigen/Core>

#include "surface/point_lattice.h"

namespace morphgrid {

/// A conformal map of a four-sided surface to a rectangle, which is scaled to the unit square: the
/// lines of constant (u, v) cross at right angles.
struct ConformalMap {
  int countU;
  int countV;
  /// (u, v) of every point of the lattice, 2 x countU countV, linear within triangles. The sides
  /// map to the sides: u is exactly 0 and 1 in the first and last column, v in the rows.
  Eigen::Matrix2Xd values;
  /// The lattice's triangles, 3 x n, counter-clockwise as seen with u to the right and v upwards.
  Eigen::Matrix3Xi triangles;
  double modulus;  ///< Extent of the rectangle along v over that along u.
};

/// Solves the Laplace equation twice with the cotangent weights of linear finite elements (Pinkall
/// and Polthier, "Computing Discrete Minimal Surfaces and Their Conjugates"): u is 0 and 1 on two
/// opposite sides, v on the other two, with natural boundary conditions elsewhere. The error falls
/// with the square of the lattice's spacing, more slowly where a corner is far from a right angle.
///
/// The points lie at the parameters (i / (countU-1), j / (countV-1)). Throws InputError where the
/// lattice has no area.
ConformalMap mapConformally(const PointLattice& lattice);

}  // namespace morphgrid
