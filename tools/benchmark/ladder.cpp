#include "benchmark/ladder.h"

#include <Eigen/Geometry>
#include <cmath>

namespace morphgrid {
namespace {

constexpr int kEndCells = 2;

}  // namespace

StrutGrid ladderGrid(const Ladder& ladder) {
  const GridShape shape{ladder.cells + 1, 1, 2};
  StrutGrid grid{
      shape, 1, Eigen::Matrix3Xd(3, shape.vertexCount()), StrutValues(shape), StrutValues(shape),
      {}};
  forEachVertex(shape, [&](const GridPlace& place) {
    grid.positions.col(shape.index(place)) << place.i, 0, ladder.layerSpacing * place.layer;
  });
  forEachStrut(shape, [&](const Strut& strut) {
    const double shrink = strut.layer == 0 ? ladder.bottomShrink : ladder.topShrink;
    valueAt(grid.rest, strut) = strut.isLateral() ? 1 - shrink : ladder.layerSpacing;
    valueAt(grid.stiffness, strut) = strut.isLateral() ? kLateralWeight : kVerticalWeight;
  });
  return grid;
}

double closedFormTurn(const Ladder& ladder, double thickness, const JointModel& joint) {
  const double bottom = 1 - ladder.bottomShrink;
  const double top = 1 - ladder.topShrink;
  const double rigid = 2 * joint.radius * thickness;
  const double tau = ladder.layerSpacing;
  const double soft = bottom + top - 2 * rigid;
  return tau * (bottom - top) /
         (tau * tau +
          thickness * thickness / 12 * soft * soft / ((bottom - rigid) * (top - rigid)));
}

StrutGrid inTwoRows(const StrutGrid& grid) {
  const GridShape shape{grid.shape.verticesU, 2, grid.shape.layers};
  StrutGrid result{shape,
                   grid.spacing,
                   Eigen::Matrix3Xd(3, shape.vertexCount()),
                   StrutValues(shape),
                   StrutValues(shape),
                   grid.weights};
  const auto single = [&](int vertex) {
    const GridPlace place = shape.place(vertex);
    return grid.shape.index(place.i, 0, place.layer);
  };
  forEachVertex(shape, [&](const GridPlace& place) {
    const int vertex = shape.index(place);
    result.positions.col(vertex) =
        grid.positions.col(single(vertex)) + place.j * grid.spacing * Eigen::Vector3d::UnitY();
  });
  forEachStrut(shape, [&](const Strut& strut) {
    const bool joins = strut.direction == Strut::Direction::v;
    const Strut original{single(strut.from), single(strut.to), strut.direction, strut.layer};
    valueAt(result.rest, strut) = joins ? grid.spacing : valueAt(grid.rest, original);
    valueAt(result.stiffness, strut) =
        joins ? grid.stiffness.u.front() : valueAt(grid.stiffness, original);
  });
  return result;
}

Eigen::Matrix3Xd firstRow(const GridShape& shape, const Eigen::Matrix3Xd& positions) {
  const GridShape row{shape.verticesU, 1, shape.layers};
  Eigen::Matrix3Xd result(3, row.vertexCount());
  forEachVertex(row, [&](const GridPlace& place) {
    result.col(row.index(place)) = positions.col(shape.index(place));
  });
  return result;
}

LadderTurns turnsOf(const Eigen::Matrix3Xd& positions) {
  const Eigen::Index posts = positions.cols() / 2;
  const Eigen::Matrix3Xd along = positions.rightCols(posts) - positions.leftCols(posts);
  LadderTurns turns{0, 0};
  const Eigen::Index cells = posts - 1;
  for (Eigen::Index n = 0; n < cells; ++n) {
    const Eigen::Vector3d here = along.col(n);
    const Eigen::Vector3d next = along.col(n + 1);
    const double turn = std::atan2(here.cross(next).norm(), here.dot(next));
    turns.total += turn;
    if (n >= kEndCells && n < cells - kEndCells) {
      turns.inner += turn / static_cast<double>(cells - 2 * kEndCells);
    }
  }
  return turns;
}

}  // namespace morphgrid
