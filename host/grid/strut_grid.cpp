#include "grid/strut_grid.h"

#include <fmt/format.h>

#include <cmath>

#include "core/error.h"

namespace morphgrid {
namespace {

constexpr double kFlat = 1e-6;  // Of a direction.

void requirePositive(double value, const char* what, const Strut& strut) {
  if (!(std::isfinite(value) && value > 0)) {
    throw InputError(fmt::format("strut {} -> {}: {} must be a finite number > 0, got {}",
                                 strut.from, strut.to, what, value));
  }
}

bool hasSize(const StrutValues& values, std::size_t count) {
  return values.u.size() == count && values.v.size() == count && values.w.size() == count;
}

void requirePositive(double value, const char* what) {
  if (!(std::isfinite(value) && value > 0)) {
    throw InputError(fmt::format("{} must be a finite number > 0, got {}", what, value));
  }
}

void validateSection(const BarSection& section) {
  requirePositive(section.stretching, "the stiffness of bars against stretching");
  requirePositive(section.bendingN, "the stiffness of bars against bending in the sheet");
  requirePositive(section.bendingB, "the stiffness of bars against bending across");
  requirePositive(section.twisting, "the stiffness of bars against twisting");
  for (const double value : {section.shearing, section.joint}) {
    if (!(std::isfinite(value) && value >= 0)) {
      throw InputError(fmt::format(
          "what bars shear by and the size of their joints must be finite numbers >= 0, got {}",
          value));
    }
  }
}

void validateLoads(const JointLoads& loads, int vertexCount) {
  if (loads.forces.cols() != vertexCount || !loads.forces.allFinite()) {
    throw InputError(
        fmt::format("joints need {} finite forces, got {}", vertexCount, loads.forces.cols()));
  }
  if (loads.held.empty()) {
    throw InputError("a frame with forces on its joints needs a joint that is held");
  }
  for (const int joint : loads.held) {
    if (joint < 0 || joint >= vertexCount) {
      throw InputError(
          fmt::format("a joint that is held must be >= 0 and < {}, got {}", vertexCount, joint));
    }
  }
}

void validateBars(const StrutGrid& grid) {
  const Bars& bars = *grid.bars;
  if (bars.printed.cols() != grid.shape.vertexCount() || !bars.printed.allFinite()) {
    throw InputError(fmt::format("bars need {} finite printed positions, got {}",
                                 grid.shape.vertexCount(), bars.printed.cols()));
  }
  validateSection(bars.lateral);
  if (grid.shape.layers > 1) {
    validateSection(bars.upright);
  }
  if (bars.loads) {
    validateLoads(*bars.loads, grid.shape.vertexCount());
  }
  forEachStrut(grid.shape, [&](const Strut& strut) {
    requirePositive(lengthAt(bars.printed, strut), "the printed length", strut);
    requirePositive(valueAt(grid.rest, strut) - 2 * bars.section(strut).joint,
                    "the rest length beyond the joints", strut);
    const Eigen::Vector3d along = printedDirection(bars, strut);
    if (strut.isLateral() ? std::abs(along.z()) > kFlat : along.z() < 1 - kFlat) {
      throw InputError(fmt::format(
          "strut {} -> {} is printed along ({:.3g}, {:.3g}, {:.3g}), but layers are printed flat "
          "and posts upright",
          strut.from, strut.to, along.x(), along.y(), along.z()));
    }
  });
}

void validatePrintedCorners(const StrutGrid& grid) {
  const Eigen::Matrix3Xd& printed = *grid.printedCorners;
  if (printed.cols() != grid.shape.vertexCount() || !printed.allFinite()) {
    throw InputError(fmt::format("corners as printed need {} finite positions, got {}",
                                 grid.shape.vertexCount(), printed.cols()));
  }
  forEachLateralStrut(grid.shape, [&](const Strut& strut) {
    requirePositive(lengthAt(printed, strut), "the printed length", strut);
    const double rise = printed(2, strut.to) - printed(2, strut.from);
    if (std::abs(rise) > kFlat * lengthAt(printed, strut)) {
      throw InputError(fmt::format("strut {} -> {} rises by {:.3g}, but layers are printed flat",
                                   strut.from, strut.to, rise));
    }
  });
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
  if (grid.bars) {
    validateBars(grid);
  }
  if (grid.printedCorners) {
    validatePrintedCorners(grid);
  }
}

std::vector<int> freeMotions(const StrutGrid& grid) {
  if (!grid.bars || !grid.bars->loads) {
    return {0, 1, 2, 3, 4, 5};
  }
  return grid.bars->loads->slide ? std::vector{0, 1, 5} : std::vector<int>{};
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
