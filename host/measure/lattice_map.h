#pragma once
#include <Eigen/Core>
#include <Eigen/SparseCore>

#include "surface/point_lattice.h"

namespace morphgrid {

/// A map of a four-sided surface to the unit square, linear in the triangles of a lattice. Lines of
/// constant (u, v) make a net.
struct LatticeMap {
  int countU;
  int countV;
  /// (u, v) of every point of the lattice, 2 x countU countV. The sides map to the sides: u is
  /// exactly 0 and 1 in the first and last column, v in the rows.
  Eigen::Matrix2Xd values;
  /// The lattice's triangles, 3 x n, counter-clockwise as seen with u to the right and v upwards.
  Eigen::Matrix3Xi triangles;
  /// Extent along v over that along u of the rectangle that stands for the surface: of a conformal
  /// map, the one that the surface maps to.
  double modulus;
};

/// The lattice's triangles. Cells are cut along the diagonal whose cotangent weight is not
/// negative. The points lie at the parameters (i / (countU-1), j / (countV-1)). Throws InputError
/// where the lattice has no area.
Eigen::Matrix3Xi triangulate(const PointLattice& lattice);

/// (u, v) of a point of the lattice, in [0, 1]^2.
Eigen::Vector2d parametersOf(const PointLattice& lattice, int point);

/// The integral of |grad f|^2 by linear finite elements, half of it: cotangent weights (Pinkall and
/// Polthier, "Computing Discrete Minimal Surfaces and Their Conjugates").
Eigen::SparseMatrix<double> cotangentLaplacian(const Eigen::Matrix3Xd& points,
                                               const Eigen::Matrix3Xi& triangles);

/// The map whose u is 0 and 1 on two opposite sides and makes the quadratic form ofU least, and
/// whose v does so on the other two for ofV. The modulus comes from their Dirichlet energies.
/// Throws InputError where the surface is too rough.
LatticeMap solveMap(const PointLattice& lattice, Eigen::Matrix3Xi triangles,
                    const Eigen::SparseMatrix<double>& ofU, const Eigen::SparseMatrix<double>& ofV);

}  // namespace morphgrid
