#include "grid/strut_grid.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"

namespace morphgrid {
namespace {

void requirePositive(double value, const char* what, const Strut& strut) {
  if (!(std::isfinite(value) && value > 0)) {
    throw InputError(fmt::format("strut {} -> {}: {} must be a finite number > 0, got {}",
                                 strut.from, strut.to, what, value));
  }
}

bool hasSize(const StrutValues& values, std::size_t count) {
  return values.u.size() == count && values.v.size() == count && values.w.size() == count;
}

}  // namespace

void validate(const StrutGrid& grid) {
  const GridShape& shape = grid.shape;
  if (shape.verticesU < 2 || shape.verticesV < 2 || shape.layers < 1) {
    throw InputError(
        fmt::format("a grid needs at least 2 x 2 vertices and 1 layer, got {} x {} x {}",
                    shape.verticesU, shape.verticesV, shape.layers));
  }
  const auto count = static_cast<std::size_t>(shape.vertexCount());
  if (static_cast<std::size_t>(grid.positions.cols()) != count || !hasSize(grid.rest, count) ||
      !hasSize(grid.stiffness, count)) {
    throw InputError(
        fmt::format("a grid of {} vertices needs as many positions, rest lengths and "
                    "stiffnesses, got {}, {} and {}",
                    count, grid.positions.cols(), grid.rest.u.size(), grid.stiffness.u.size()));
  }
  if (!(std::isfinite(grid.spacing) && grid.spacing > 0)) {
    throw InputError(fmt::format("the spacing must be a finite number > 0, got {}", grid.spacing));
  }
  for (const TermWeight& weight : kTermWeights) {
    const double value = grid.weights.*weight.value;
    if (!(std::isfinite(value) && value >= 0)) {
      throw InputError(
          fmt::format("the {} weight must be a finite number >= 0, got {}", weight.name, value));
    }
  }
  if (!grid.positions.allFinite()) {
    throw InputError("every position of the grid must be finite");
  }
  forEachStrut(shape, [&](const Strut& strut) {
    requirePositive(valueAt(grid.rest, strut), "the rest length", strut);
    requirePositive(valueAt(grid.stiffness, strut), "the stiffness", strut);
    requirePositive(lengthAt(grid.positions, strut), "the initial length", strut);
  });
}

StrutGrid layerAtRest(const GridShape& shape, double spacing, const Eigen::Matrix3Xd& points) {
  const GridShape layer = shape.layer();
  StrutGrid grid{layer, spacing, points, StrutValues(layer), StrutValues(layer), {}};
  forEachStrut(layer, [&](const Strut& strut) {
    valueAt(grid.rest, strut) = lengthAt(points, strut);
    valueAt(grid.stiffness, strut) = 1;
  });
  return grid;
}

Eigen::Matrix3Xd middleLayer(const GridShape& shape, const Eigen::Matrix3Xd& positions) {
  return 0.5 * (layerOf(shape, positions, (shape.layers - 1) / 2) +
                layerOf(shape, positions, shape.layers / 2));
}

}  // namespace morphgrid
