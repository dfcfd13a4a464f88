#include "grid/strut_grid.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"

namespace morphgrid {
namespace {

template <typename Values>  // StrutValues or const StrutValues
auto& along(Values& values, Strut::Direction direction) {
  switch (direction) {
    case Strut::Direction::u:
      return values.u;
    case Strut::Direction::v:
      return values.v;
    default:
      return values.w;
  }
}

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

std::vector<Strut> listStruts(const GridShape& shape) {
  std::vector<Strut> struts;
  struts.reserve(shape.strutCount());
  for (int k = 0; k < shape.layers; ++k) {
    for (int j = 0; j < shape.verticesV; ++j) {
      for (int i = 0; i < shape.verticesU; ++i) {
        const int from = shape.index(i, j, k);
        if (i + 1 < shape.verticesU) {
          struts.push_back({from, shape.index(i + 1, j, k), Strut::Direction::u, k});
        }
        if (j + 1 < shape.verticesV) {
          struts.push_back({from, shape.index(i, j + 1, k), Strut::Direction::v, k});
        }
        if (k + 1 < shape.layers) {
          struts.push_back({from, shape.index(i, j, k + 1), Strut::Direction::w, k});
        }
      }
    }
  }
  return struts;
}

double valueAt(const StrutValues& values, const Strut& strut) {
  return along(values, strut.direction)[strut.from];
}

double& valueAt(StrutValues& values, const Strut& strut) {
  return along(values, strut.direction)[strut.from];
}

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
  if (!(std::isfinite(grid.angleWeight) && grid.angleWeight >= 0)) {
    throw InputError(
        fmt::format("the angle weight must be a finite number >= 0, got {}", grid.angleWeight));
  }
  if (!grid.positions.allFinite()) {
    throw InputError("every position of the grid must be finite");
  }
  for (const Strut& strut : listStruts(shape)) {
    requirePositive(valueAt(grid.rest, strut), "the rest length", strut);
    requirePositive(valueAt(grid.stiffness, strut), "the stiffness", strut);
    requirePositive((grid.positions.col(strut.to) - grid.positions.col(strut.from)).norm(),
                    "the initial length", strut);
  }
}

StrutGrid layerAtRest(const GridShape& shape, double spacing, const Eigen::Matrix3Xd& points) {
  const GridShape layer{shape.verticesU, shape.verticesV, 1};
  StrutGrid grid{layer, spacing, points, StrutValues(layer), StrutValues(layer), 1.0};
  for (const Strut& strut : listStruts(layer)) {
    valueAt(grid.rest, strut) = (points.col(strut.to) - points.col(strut.from)).norm();
    valueAt(grid.stiffness, strut) = 1;
  }
  return grid;
}

Eigen::Matrix3Xd middleLayer(const GridShape& shape, const Eigen::Matrix3Xd& positions) {
  const int count = shape.layerVertexCount();
  const int below = (shape.layers - 1) / 2;
  const int above = shape.layers / 2;
  return 0.5 *
         (positions.middleCols(below * count, count) + positions.middleCols(above * count, count));
}

}  // namespace morphgrid
