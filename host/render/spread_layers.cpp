#include "render/spread_layers.h"

#include <algorithm>

namespace morphgrid {
namespace {

constexpr double kGap = 0.1;  // Between layers, of their longer side.

int rowsFor(int layers, int columns) { return (layers + columns - 1) / columns; }

/// cell: what a layer takes up, with the gap.
int chooseColumns(int layers, const Eigen::Vector2d& cell, double aspect) {
  const auto magnification = [&](int columns) {
    return std::min(aspect / (columns * cell.x()), 1 / (rowsFor(layers, columns) * cell.y()));
  };
  int best = 1;
  for (int columns = 2; columns <= layers; ++columns) {
    best = magnification(columns) > magnification(best) ? columns : best;
  }
  return best;
}

}  // namespace

StrutGrid spreadLayers(const StrutGrid& stacked, double aspect) {
  const int layers = stacked.shape.layers;
  const auto layer = layerOf(stacked.shape, stacked.positions, 0).topRows<2>();
  const Eigen::Vector2d extent = layer.rowwise().maxCoeff() - layer.rowwise().minCoeff();
  const Eigen::Vector2d cell = extent.array() + kGap * extent.maxCoeff();
  const int columns = chooseColumns(layers, cell, aspect);
  StrutGrid spread = stacked;
  for (int k = 0; k < layers; ++k) {
    const int row = k / columns;
    const Eigen::Vector3d moved((k % columns) * cell.x(), -row * cell.y(), 0);
    layerOf(stacked.shape, spread.positions, k) =
        layerOf(stacked.shape, stacked.positions, 0).colwise() + moved;
  }
  return spread;
}

}  // namespace morphgrid
