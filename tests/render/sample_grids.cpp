#include "tests/render/sample_grids.h"

#include <algorithm>

namespace morphgrid {

StrutGrid gridThrough(const GridShape& shape,
                      const std::function<Eigen::Vector3d(int i, int j, int k)>& pointAt,
                      double strain) {
  StrutGrid grid;
  grid.shape = shape;
  grid.positions.resize(3, shape.vertexCount());
  for (int k = 0; k < shape.layers; ++k) {
    for (int j = 0; j < shape.verticesV; ++j) {
      for (int i = 0; i < shape.verticesU; ++i) {
        grid.positions.col(shape.index(i, j, k)) = pointAt(i, j, k);
      }
    }
  }
  grid.rest = StrutValues(shape);
  grid.stiffness = StrutValues(shape);
  grid.weights = TermWeights::ofAllCorners(1);
  grid.spacing = 0;
  forEachStrut(shape, [&](const Strut& strut) {
    const double length = (grid.positions.col(strut.to) - grid.positions.col(strut.from)).norm();
    valueAt(grid.rest, strut) = length / (1 + strain);
    valueAt(grid.stiffness, strut) = 5;
    grid.spacing = std::max(grid.spacing, length);
  });
  return grid;
}

StrutGrid flatGrid(const GridShape& shape, double spacing, double strain) {
  const auto pointAt = [&](int i, int j, int k) {
    return Eigen::Vector3d(i * spacing, j * spacing, 0.3 * k * spacing);
  };
  return gridThrough(shape, pointAt, strain);
}

StrutGrid saddleGrid(const GridShape& shape) {
  const auto pointAt = [&](int i, int j, int k) {
    const double x = i - (shape.verticesU - 1) / 2.0;
    const double y = j - (shape.verticesV - 1) / 2.0;
    const double bend = 1.2 / std::max(shape.verticesU, shape.verticesV);
    return Eigen::Vector3d(x, y, bend * (x * x - y * y) + 0.4 * k);
  };
  StrutGrid grid = gridThrough(shape, pointAt);
  const StrutGrid flat = flatGrid(shape);
  grid.rest.u = flat.rest.u;
  grid.rest.v = flat.rest.v;
  return grid;
}

}  // namespace morphgrid
