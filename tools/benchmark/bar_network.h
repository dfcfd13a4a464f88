#pragma once
#include <Eigen/Core>
#include <vector>

#include "energy/beam_term.h"
#include "grid/joint_rotations.h"

namespace morphgrid {

/// Bars between any joints, with moments that act on them: for what grids have no place for. The
/// first joint is clamped.
struct BarNetwork {
  struct Bar {
    BeamTerm term;
    Edge edge;
  };
  std::vector<Bar> bars;
  Eigen::Matrix3Xd moments;  ///< 3 x joints, in space: do not turn with the joints.
};

struct NetworkState {
  Eigen::Matrix3Xd positions;  ///< 3 x joints
  JointRotations rotations;    ///< 4 x joints
};

/// Where the network comes to rest, near `start`: Newton's method in double precision, without
/// a search along the line.
/// Throws std::runtime_error when it does not converge.
NetworkState solveNetwork(const BarNetwork& network, NetworkState start);

/// A chain of `pieces` bars along x, one long in all, square and slender, which bend in the plane y
/// = 0 under an end moment that makes them a full circle, 2 pi EI / length; where it comes to rest.
NetworkState rolledChain(int pieces);

/// The frame with each bar cut in two, and a place near its equilibrium. grid: with bars that are
/// not rigid within joints; the grid's joints come first.
BarNetwork halvedBars(const StrutGrid& grid);
NetworkState halvedState(const StrutGrid& grid, const NetworkState& state);

}  // namespace morphgrid
