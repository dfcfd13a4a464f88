#include "report/feasibility.h"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>

#include "grid/surface_mesh.h"
#include "surface/segment_clearance.h"
#include "surface/self_intersection.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;
using Eigen::Vector3d;

/// From the bottom to the top layer, at a cell's four columns.
Vector3d upwards(const GridShape& shape, const Matrix3Xd& x, const Cell& cell) {
  if (shape.layers == 1) {
    return Vector3d::UnitZ();
  }
  Vector3d sum = Vector3d::Zero();
  for (const int vertex : cell.vertices) {
    const int column = shape.column(vertex);
    sum += x.col(shape.index(column, shape.layers - 1)) - x.col(column);
  }
  return sum.stableNormalized();
}

/// See report.md; 0 for a cell whose sides have no length.
double relativeArea(const GridShape& shape, const Matrix3Xd& x, const Cell& cell) {
  const auto corner = [&](int di, int dj) { return x.col(cell.vertex(di, dj)); };
  const Vector3d rising = corner(1, 1) - corner(0, 0);
  const Vector3d falling = corner(0, 1) - corner(1, 0);
  const double area = 0.5 * rising.cross(falling).dot(upwards(shape, x, cell));
  const double sideU =
      ((corner(1, 0) - corner(0, 0)).norm() + (corner(1, 1) - corner(0, 1)).norm()) / 2;
  const double sideV =
      ((corner(0, 1) - corner(0, 0)).norm() + (corner(1, 1) - corner(1, 0)).norm()) / 2;
  return sideU * sideV > 0 ? area / (sideU * sideV) : 0;
}

void add(CellFigures& figures, double area, const GridPlace& cell) {
  figures.inverted += area < -kCollapsedArea ? 1 : 0;
  figures.collapsed += std::abs(area) <= kCollapsedArea ? 1 : 0;
  if (area < figures.smallestRelativeArea) {
    figures.smallestRelativeArea = area;
    figures.smallest = cell;
  }
}

/// The ends of every strut.
Matrix2Xi segmentsOf(const GridShape& shape) {
  Matrix2Xi segments(2, shape.strutCount());
  Eigen::Index n = 0;
  forEachStrut(shape, [&](const Strut& strut) { segments.col(n++) << strut.from, strut.to; });
  return segments;
}

std::string describe(const GridPlace& place) {
  return fmt::format("({}, {}) of layer {}", place.i, place.j, place.layer);
}

/// "1 cell is", "2 cells are".
std::string count(int number, const char* what, const char* singular, const char* plural) {
  return fmt::format("{} {}{} {}", number, what, number == 1 ? "" : "s",
                     number == 1 ? singular : plural);
}

}  // namespace

CellFigures examineCells(const GridShape& shape, const Matrix3Xd& positions) {
  CellFigures figures;
  forEachCell(shape, [&](const Cell& cell) {
    add(figures, relativeArea(shape, positions, cell), cell.place);
  });
  return figures;
}

SelfIntersection findSelfIntersection(const GridShape& shape, const Matrix3Xd& positions) {
  const Eigen::Matrix3Xi triangles = latticeTriangles(shape.layer());
  std::vector<int> cells = findSelfIntersections(middleLayer(shape, positions), triangles);
  for (int& triangle : cells) {
    triangle /= 2;
  }
  cells.erase(std::unique(cells.begin(), cells.end()), cells.end());
  if (cells.empty()) {
    return {};
  }
  const GridPlace first = shape.place(triangles(0, 2 * cells.front()));
  return {static_cast<int>(cells.size()), {first.i, first.j, (shape.layers - 1) / 2}};
}

CloseStruts findCloseStruts(const GridShape& shape, const Matrix3Xd& positions, double thickness) {
  const Matrix2Xi segments = segmentsOf(shape);
  const Eigen::VectorXd clearances = segmentClearances(positions, segments, thickness);
  Eigen::Index closest = 0;
  const double smallest = clearances.minCoeff(&closest);
  return {thickness, static_cast<int>((clearances.array() < thickness).count()),
          std::min(smallest, thickness), shape.place(segments(0, closest))};
}

Feasibility examineFeasibility(const GridShape& shape, const Matrix3Xd& positions,
                               const std::optional<double>& strutThickness) {
  Feasibility result{examineCells(shape, positions), findSelfIntersection(shape, positions), {}};
  if (strutThickness) {
    result.closeStruts = findCloseStruts(shape, positions, *strutThickness);
  }
  return result;
}

std::vector<std::string> adviseOn(const Feasibility& feasibility) {
  std::vector<std::string> advice;
  const CellFigures& cells = feasibility.cells;
  if (cells.inverted + cells.collapsed > 0) {
    advice.push_back(fmt::format(
        "{} inverted and {} collapsed, worst the cell at {}: the grid folds instead of bending; "
        "use more nodes, a larger weights.angle or a smaller grid.curvature_cutoff",
        count(cells.inverted, "cell", "is", "are"), cells.collapsed, describe(cells.smallest)));
  }
  const SelfIntersection& cut = feasibility.selfIntersection;
  if (cut.cells > 0) {
    advice.push_back(fmt::format(
        "{} through another, first the cell at {}: the result cannot be reached without passing "
        "through itself; trim the target or bend it less",
        count(cut.cells, "cell", "cuts", "cut"), describe(cut.first)));
  }
  if (feasibility.closeStruts && feasibility.closeStruts->count > 0) {
    const CloseStruts& close = *feasibility.closeStruts;
    advice.push_back(fmt::format(
        "{} closer to another than grid.strut_thickness = {:g}, as close as {:.3g} at {}: print "
        "thinner struts, use fewer nodes or a larger grid.layer_spacing",
        count(close.count, "strut", "comes", "come"), close.thickness, close.smallestClearance,
        describe(close.closest)));
  }
  return advice;
}

}  // namespace morphgrid
