#pragma once
#include "measure/lattice_map.h"
#include "measure/net.h"

namespace morphgrid {

/// The net along lines of constant (u, v) of a map, evenly spaced in them: the map's
/// inverse at (i / nodesU, j / nodesV), exact for the map as it is, linear within triangles.
/// Vertices on the net's sides lie exactly on the target's, corners on its corners.
///
/// Throws InputError when the net is folded. The lattice of the map should be finer than the net.
Net mappedNet(const LatticeMap& map, int nodesU, int nodesV);

}  // namespace morphgrid
