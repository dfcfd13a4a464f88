#pragma once
#include <Eigen/Core>
#include <array>
#include <functional>

#include "grid/grid_topology.h"
#include "surface/point_lattice.h"

namespace morphgrid {

/// How the lines of a net run.
enum class NetKind {
  isoline,     ///< Along the isolines of the parameters, evenly spaced in them.
  orthogonal,  ///< Crossing at right angles.
  principal,   ///< Along the lines of curvature, as far as the target's sides allow.
};

/// As scene files call them.
inline constexpr std::array kNetWords = {"isoline", "orthogonal", "principal"};
constexpr const char* nameOf(NetKind kind) { return kNetWords[static_cast<std::size_t>(kind)]; }

/// Where the vertices of a grid lie on the target.
struct Net {
  int nodesU;
  int nodesV;
  /// (u, v) of each vertex, of a patch or of a mesh's box, in [0, 1]^2; 2 x (nodesU+1)(nodesV+1),
  /// index j (nodesU+1) + i.
  Eigen::Matrix2Xd parameters;
  bool followsIsolines = false;  ///< The parameters are those of isolineNet().

  GridShape shape() const { return {nodesU + 1, nodesV + 1, 1}; }
  int index(int i, int j) const { return shape().index(i, j, 0); }
};

/// Vertex (i, j) at (i / nodesU, j / nodesV). nodesU, nodesV >= 1.
Net isolineNet(int nodesU, int nodesV);

/// Throws InputError, with the place, when a node of the net is folded or has no area in the plane
/// of the parameters.
void requireUnfolded(const Net& net);

/// How even and how orthogonal a net is on its surface.
struct NetQuality {
  double strutRatio;  ///< Longest over shortest chord between neighbours; infinite when one is 0.
  double meanAngleDeviation;     ///< How far the angles between neighbouring chords are from 90
                                 ///< degrees on average, rad.
  double largestAngleDeviation;  ///< rad
};
NetQuality assessNet(const PointLattice& points);

/// The points of a net on its target, in the net's order.
using NetPoints = std::function<PointLattice(const Net&)>;

struct BlendedNet {
  Net net;
  double blend;  ///< Share of the isolines, in [0, 1].
};

/// Blends the parameters towards those of the isolines, as little as it takes for the strut ratio
/// to be no more than maxRatio. Where no blend will do: the one of the smallest ratio.
BlendedNet boundStrutRatio(const Net& net, double maxRatio, const NetPoints& pointsOf);

}  // namespace morphgrid
