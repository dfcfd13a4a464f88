#pragma once
#include "grid/strut_grid.h"

namespace morphgrid {

/// 4 x 3 x 2 vertices, cells of 2 x 2, layers 1 apart, at rest; stiffness 3.
inline StrutGrid stackedGridOfTwoLayers() {
  const GridShape shape{4, 3, 2};
  StrutGrid grid{
      shape, 2, Eigen::Matrix3Xd(3, shape.vertexCount()), StrutValues(shape), StrutValues(shape),
      {}};
  forEachVertex(shape, [&](const GridPlace& place) {
    grid.positions.col(shape.index(place)) << 2 * place.i, 2 * place.j, place.layer;
  });
  forEachStrut(shape, [&](const Strut& strut) {
    valueAt(grid.rest, strut) = lengthAt(grid.positions, strut);
    valueAt(grid.stiffness, strut) = 3;
  });
  return grid;
}

}  // namespace morphgrid
