#include "design/build_grids.h"

#include <cmath>

namespace morphgrid {
namespace {

void setStiffness(StrutGrid& grid, const Weights& weights, Scaling scaling) {
  for (const Strut& strut : listStruts(grid.shape)) {
    const double weight =
        strut.direction == Strut::Direction::w ? weights.vertical : weights.lateral;
    double c = 1;
    if (scaling == Scaling::shapeop) {
      const double rest = valueAt(grid.rest, strut);
      c = (grid.positions.col(strut.to) - grid.positions.col(strut.from)).norm() / (rest * rest);
    }
    valueAt(grid.stiffness, strut) = weight * c;
  }
}

StrutGrid emptyGrid(const GridDesign& design, int layers, const Weights& weights) {
  const GridShape shape{design.nodesU + 1, design.nodesV + 1, layers};
  return {shape,
          design.spacing,
          Eigen::Matrix3Xd(3, shape.vertexCount()),
          StrutValues(shape),
          StrutValues(shape),
          weights.angle};
}

void setLateralRest(StrutGrid& grid, int layer, const LateralField<double>& rest) {
  forEachLateralStrut(rest.nodesU(), rest.nodesV(), [&](const LateralStrut& strut) {
    StrutValues& values = grid.rest;
    (strut.alongU ? values.u : values.v)[grid.shape.index(strut.i, strut.j, layer)] =
        rest.at(strut);
  });
}

}  // namespace

StrutGrid inPlaneGrid(const GridDesign& design, const Weights& weights, Scaling scaling) {
  StrutGrid grid = emptyGrid(design, 1, weights);
  for (int j = 0; j <= design.nodesV; ++j) {
    for (int i = 0; i <= design.nodesU; ++i) {
      grid.positions.col(grid.shape.index(i, j, 0)) =
          Eigen::Vector3d(i * design.spacing, j * design.spacing, 0);
    }
  }
  setLateralRest(grid, 0, design.lengths);
  setStiffness(grid, weights, scaling);
  return grid;
}

StrutGrid stackedGrid(const GridDesign& design, const Weights& weights, Scaling scaling,
                      const Eigen::Matrix3Xd& printedLayer) {
  StrutGrid grid = emptyGrid(design, design.layers, weights);
  const GridShape& shape = grid.shape;
  const int layerCount = shape.layerVertexCount();
  for (int k = 0; k < shape.layers; ++k) {
    auto layer = grid.positions.middleCols(k * layerCount, layerCount);
    layer = printedLayer;
    layer.row(2).setConstant(k * design.layerSpacing);
    setLateralRest(grid, k, design.rest[k]);
  }
  for (int index = 0; index < (shape.layers - 1) * layerCount; ++index) {
    grid.rest.w[index] = design.layerSpacing;
  }
  setStiffness(grid, weights, scaling);
  return grid;
}

}  // namespace morphgrid
