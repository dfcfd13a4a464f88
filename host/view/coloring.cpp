#include "view/coloring.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>

#include "core/bounding_diagonal.h"
#include "grid/shrink.h"
#include "shared/share_color.h"

namespace morphgrid {
namespace {

StrutValues shrinkShares(const StrutGrid& grid, double maxShrinkage) {
  StrutValues shares = computeShrinks(grid);
  for (std::vector<double>* direction : {&shares.u, &shares.v, &shares.w}) {
    for (double& share : *direction) {
      share /= maxShrinkage;
    }
  }
  return shares;
}

StrutValues layerShares(const GridShape& shape) {
  StrutValues shares(shape);
  const double top = std::max(shape.layers - 1, 1);
  forEachStrut(shape, [&](const Strut& strut) {
    const double half = strut.isLateral() ? 0 : 0.5;
    valueAt(shares, strut) = (strut.layer + half) / top;
  });
  return shares;
}

Eigen::VectorXd targetDistances(const ShownGrid& shown, const Eigen::Matrix3Xd& targets) {
  const Eigen::Matrix3Xd aligned = shown.worldFromGrid * *shown.positions;
  return (middleLayer(shown.grid->shape, aligned) - targets).colwise().norm();
}

/// A strut's share is the mean of those of its ends' columns.
StrutValues strutShares(const GridShape& shape, const Eigen::VectorXd& columns) {
  StrutValues shares(shape);
  forEachStrut(shape, [&](const Strut& strut) {
    valueAt(shares, strut) =
        0.5 * (columns[shape.column(strut.from)] + columns[shape.column(strut.to)]);
  });
  return shares;
}

Legend layerLegend(int layers) {
  return {"layer",
          [](double place) { return shareColor(static_cast<float>(place)); },
          {{0, "bottom", ""}, {1, fmt::format("top ({})", layers), ""}}};
}

}  // namespace

bool canColor(Coloring coloring, const ShownGrid& shown, const Snapshot& snapshot) {
  switch (coloring) {
    case Coloring::strain:
      return true;
    case Coloring::shrink:
    case Coloring::layer:
      return shown.grid != nullptr;
    case Coloring::distance:
      break;
  }
  return shown.grid && shown.positions && snapshot.targets &&
         snapshot.targets->cols() == shown.grid->shape.layerVertexCount();
}

ColorShares computeColors(Coloring coloring, const ShownGrid& shown, const Snapshot& snapshot) {
  assert(coloring != Coloring::strain && canColor(coloring, shown, snapshot));
  const GridShape& shape = shown.grid->shape;
  if (coloring == Coloring::shrink) {
    return {shrinkShares(*shown.grid, snapshot.maxShrinkage), {}, shrinkLegend()};
  }
  if (coloring == Coloring::layer) {
    return {layerShares(shape), {}, layerLegend(shape.layers)};
  }
  const Eigen::Matrix3Xd& targets = *snapshot.targets;
  const Eigen::VectorXd distances = targetDistances(shown, targets);
  const double largest = distances.maxCoeff();
  const double diagonal = boundingDiagonal(targets);
  const Eigen::VectorXd columns = distances / (largest > 0 ? largest : 1);
  return {strutShares(shape, columns), columns, distanceLegend(largest, 100 * largest / diagonal)};
}

}  // namespace morphgrid
