#pragma once
#include "measure/lattice_map.h"

namespace morphgrid {

/// A map whose lines of constant (u, v) follow the surface's lines of curvature, as far as its four
/// sides, along which the outer lines run, and its umbilics allow.
///
/// u makes the integral of `|grad u|^2 + s (grad u . d_v)^2` least, v that with d_u; d_u and d_v
/// are the principal directions nearer to the isolines along u and v. s is kStrength where the
/// principal curvatures differ by their root mean square over the surface or more and the
/// directions are those of the isolines; it vanishes at umbilics and where the directions are at 45
/// degrees to the isolines, since either could be called d_u there. With s = 0 this is
/// mapConformally().
///
/// lattice: see triangulate(). normals: unit, 3 x points. Throws InputError where the lattice has
/// no area.
LatticeMap mapAlongCurvature(const PointLattice& lattice, const Eigen::Matrix3Xd& normals);

}  // namespace morphgrid
