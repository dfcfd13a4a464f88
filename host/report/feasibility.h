#pragma once
#include <optional>
#include <string>
#include <vector>

#include "grid/strut_grid.h"
#include "report/shrink_figures.h"

namespace morphgrid {

/// A cell's relative area is its signed area, positive where it lies as printed, over that of a
/// rectangle with its mean sides: the sine of its angle where it is a parallelogram. A cell is
/// collapsed within kCollapsedArea of 0, inverted below. Its normal is the direction from the
/// bottom to the top layer there; of a single layer, which stays in its plane, +z.
constexpr double kCollapsedArea = 0.05;

struct CellFigures {
  int inverted = 0;   ///< Cells of all layers.
  int collapsed = 0;  ///< Cells of all layers.
  double smallestRelativeArea = 1;
  GridPlace smallest{};  ///< The cell of that area.
};

/// positions: 3 x vertexCount, finite.
CellFigures examineCells(const GridShape& shape, const Eigen::Matrix3Xd& positions);

/// Cells of the middle layer, two triangles each, that meet one with which they share no vertex.
struct SelfIntersection {
  int cells = 0;
  GridPlace first{};  ///< Where there is one.
};

SelfIntersection findSelfIntersection(const GridShape& shape, const Eigen::Matrix3Xd& positions);

/// Struts that come closer to another, with which they share no vertex, than struts are thick.
struct CloseStruts {
  double thickness = 0;  ///< In the scene's unit of length.
  int count = 0;
  double smallestClearance = 0;  ///< Between axes; the thickness where no strut is close.
  GridPlace closest{};           ///< Where the closest strut begins, if one is close.
};

/// thickness > 0, in the scene's unit of length.
CloseStruts findCloseStruts(const GridShape& shape, const Eigen::Matrix3Xd& positions,
                            double thickness);

/// What of a result cannot be, or cannot be printed.
struct Feasibility {
  CellFigures cells;
  SelfIntersection selfIntersection;
  std::optional<CloseStruts> closeStruts;  ///< Where a thickness is given.
};

Feasibility examineFeasibility(const GridShape& shape, const Eigen::Matrix3Xd& positions,
                               const std::optional<double>& strutThickness);

/// What was found and what to do about it, a sentence each; none where all is well.
std::vector<std::string> adviseOn(const Feasibility& feasibility);

}  // namespace morphgrid
