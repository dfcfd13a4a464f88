#include "design/build_grids.h"

#include <cmath>

namespace morphgrid {
namespace {

void setStiffness(StrutGrid& grid, const Weights& weights, Scaling scaling) {
  forEachStrut(grid.shape, [&](const Strut& strut) {
    const double weight = strut.isLateral() ? weights.lateral : weights.vertical;
    double c = 1;
    if (scaling == Scaling::shapeop) {
      const double rest = valueAt(grid.rest, strut);
      c = lengthAt(grid.positions, strut) / (rest * rest);
    }
    valueAt(grid.stiffness, strut) = weight * c;
  });
}

StrutGrid emptyGrid(const GridDesign& design, int layers, const Weights& weights) {
  const GridShape shape{design.nodesU + 1, design.nodesV + 1, layers};
  return {shape,
          design.spacing,
          Eigen::Matrix3Xd(3, shape.vertexCount()),
          StrutValues(shape),
          StrutValues(shape),
          TermWeights::ofAllCorners(weights.angle)};
}

}  // namespace

StrutGrid inPlaneGrid(const GridDesign& design, const Weights& weights, Scaling scaling) {
  StrutGrid grid = emptyGrid(design, 1, weights);
  forEachVertex(grid.shape, [&](const GridPlace& place) {
    grid.positions.col(grid.shape.index(place)) =
        Eigen::Vector3d(place.i * design.spacing, place.j * design.spacing, 0);
  });
  forEachStrut(grid.shape,
               [&](const Strut& strut) { valueAt(grid.rest, strut) = design.lengths.at(strut); });
  setStiffness(grid, weights, scaling);
  return grid;
}

StrutGrid stackedGrid(const GridDesign& design, const Weights& weights, Scaling scaling,
                      const Eigen::Matrix3Xd& printedLayer) {
  StrutGrid grid = emptyGrid(design, design.layers, weights);
  for (int k = 0; k < design.layers; ++k) {
    auto layer = layerOf(grid.shape, grid.positions, k);
    layer = printedLayer;
    layer.row(2).setConstant(k * design.layerSpacing);
  }
  forEachStrut(grid.shape, [&](const Strut& strut) {
    valueAt(grid.rest, strut) =
        strut.isLateral() ? design.rest[strut.layer].at(strut) : design.layerSpacing;
  });
  setStiffness(grid, weights, scaling);
  return grid;
}

}  // namespace morphgrid
