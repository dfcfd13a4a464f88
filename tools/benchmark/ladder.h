#pragma once
#include "benchmark/frame_reference.h"
#include "grid/strut_grid.h"

namespace morphgrid {

/// Two layers of bars, each 1 long as printed, one row: a strip that bends alike in every cell.
struct Ladder {
  int cells;
  double bottomShrink;  ///< Share of its length that a bar of the bottom layer loses.
  double topShrink;
  double layerSpacing;
};

StrutGrid ladderGrid(const Ladder& ladder);

/// Angle in rad between neighbouring posts far from the ends, where layers come to be
/// `layerSpacing * turn` of different length and each bar resists being bent and stretched (first
/// order; bars are rigid within joints).
double closedFormTurn(const Ladder& ladder, double thickness, const JointModel& joint);

/// The ladder twice, side by side, joined by bars that keep their length and have nothing to bear:
/// solvers want cells. grid: of one row, without bars.
StrutGrid inTwoRows(const StrutGrid& grid);

/// The first row's positions of a grid of any number of rows.
Eigen::Matrix3Xd firstRow(const GridShape& shape, const Eigen::Matrix3Xd& positions);

/// Angles between neighbouring posts of a ladder, in rad.
struct LadderTurns {
  double inner;  ///< Mean of all but the two cells at either end.
  double total;
};
/// positions: of one row.
LadderTurns turnsOf(const Eigen::Matrix3Xd& positions);

}  // namespace morphgrid
