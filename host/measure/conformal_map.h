#pragma once
#include "measure/lattice_map.h"

namespace morphgrid {

/// A conformal map of a four-sided surface to a rectangle, which is scaled to the unit square: the
/// lines of constant (u, v) cross at right angles.
///
/// Solves the Laplace equation twice with cotangent weights: u is 0 and 1 on two opposite sides, v
/// on the other two, with natural boundary conditions elsewhere. The error falls with the square of
/// the lattice's spacing, more slowly where a corner is far from a right angle.
///
/// The points lie at the parameters (i / (countU-1), j / (countV-1)). Throws InputError where the
/// lattice has no area.
LatticeMap mapConformally(const PointLattice& lattice);

}  // namespace morphgrid
