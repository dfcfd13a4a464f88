#include "solve/shear_length.h"

#include <algorithm>

namespace morphgrid {
namespace {

// Of a grid that nothing holds against shear: no line bends.
constexpr double kLargest = 1e12;

double meanOf(const std::vector<double>& values, int count) {
  double sum = 0;
  for (const double value : values) sum += value;
  return sum / count;
}

/// Sum over the layers of their squared distance from the middle one, in layer spacings.
double secondMoment(int layers) { return layers * (double(layers) * layers - 1) / 12; }

/// Struts stretch when a line bends, corners at the posts resist shear.
double ofSprings(const GridShape& shape, double lateral, double post, double cornerWeight) {
  const double bending = 2 * lateral * post * post * secondMoment(shape.layers);
  const double shortest = std::min(1.0, post);
  const double shear = 8 * (shape.layers - 1) * cornerWeight * shortest * shortest;
  return 12 * bending / std::max(shear, bending / kLargest);
}

/// Bars stretch and bend when a line bends, and bend twice where columns keep it from shearing.
double ofBars(const GridShape& shape, const BarSection& bar, double spacing, double post) {
  const double squared = spacing * spacing;
  const double shear = 12 * bar.bendingB * shape.layers / squared;
  const double bending = bar.stretching * post * post * secondMoment(shape.layers) + shear / 12;
  return 12 * bending / shear;
}

}  // namespace

double computeShearSquared(const StrutGrid& grid) {
  const GridShape& shape = grid.shape;
  if (shape.layers == 1) {
    return kLargest;
  }
  const int posts = shape.layerVertexCount() * (shape.layers - 1);
  const double post = meanOf(grid.rest.w, posts) / grid.spacing;
  if (grid.bars) {
    return ofBars(shape, grid.bars->lateral, grid.spacing, post);
  }
  const double lateral = meanOf(grid.stiffness.u, shape.cellsU() * shape.verticesV * shape.layers);
  return ofSprings(shape, lateral, post, grid.weights.postAngle);
}

}  // namespace morphgrid
