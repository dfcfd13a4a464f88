#pragma once
#include <Eigen/Core>
#include <vector>

#include "grid/lateral_field.h"
#include "grid/shrink.h"

namespace morphgrid {

/// One layer's net on its target, to be laid out flat.
struct SheetProblem {
  GridShape layer;           ///< Of one layer.
  Eigen::Matrix3Xd points;   ///< 3 x layerVertexCount, the target's at the joints.
  Eigen::Matrix3Xd normals;  ///< The same, unit: of the tangent planes.
  /// Rest lengths of each layer of the grid, bottom first, > 0.
  std::vector<LateralField<double>> rest;
  ShrinkBounds shrink;  ///< What struts can lose; its lengths are the scene's.
};

/// A bar of the net, seen from the tangent planes at its ends.
struct SheetBar {
  int from, to;                ///< Joints.
  double chord;                ///< On the target, > 0.
  double directionFrom;        ///< Of from -> to in the tangent plane at `from`, rad, counted from
  double directionTo;          ///< an axis of that joint; the same direction at `to`.
  double leastRest, mostRest;  ///< Over the layers.
  double shortest, longest;    ///< What it may be printed at. Equal where no length will do: then
                               ///< the one that misses by the least.
  bool isBeyondRange;          ///< Its layers alone differ by more than the material's range.
};

/// In the order of forEachLateralStrut().
std::vector<SheetBar> sheetBars(const SheetProblem& problem);

/// Around each joint: the angle from one bar to the next, in the sheet or in the tangent plane, is
/// the difference of their directions. A corner of a cell.
struct SheetCorner {
  int joint;
  int first, second;               ///< Indices of bars; the second lies to the left of the first.
  bool leavesFirst, leavesSecond;  ///< Whether the bar leaves the joint; else it arrives.
};
std::vector<SheetCorner> sheetCorners(const GridShape& layer);

/// `angle` less whole turns, in [-pi, pi].
double wrapped(double angle);

}  // namespace morphgrid
