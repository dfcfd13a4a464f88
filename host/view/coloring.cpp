#include "view/coloring.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <numbers>

#include "core/intrinsic_diagonal.h"
#include "energy/bar_state.h"
#include "grid/shrink.h"
#include "shared/share_color.h"

namespace morphgrid {
namespace {

constexpr double kDegrees = 180 / std::numbers::pi;

StrutValues dividedBy(StrutValues values, double divisor) {
  for (std::vector<double>* direction : {&values.u, &values.v, &values.w}) {
    for (double& value : *direction) {
      value /= divisor;
    }
  }
  return values;
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

/// What to divide shares by, where `largest` is 1.
double scaleOf(double largest) { return largest > 0 ? largest : 1; }

ColorShares distanceColors(const ShownGrid& shown, const Eigen::Matrix3Xd& targets) {
  const Eigen::VectorXd distances = targetDistances(shown, targets);
  const double largest = distances.maxCoeff();
  const Eigen::VectorXd columns = distances / scaleOf(largest);
  return {strutShares(shown.grid->shape, columns), columns,
          distanceLegend(largest, 100 * largest / intrinsicDiagonal(targets))};
}

ColorShares angleErrorColors(const GridShape& shape, const Eigen::VectorXd& errors) {
  const double largest = errors.maxCoeff();
  const Eigen::VectorXd columns = errors / scaleOf(largest);
  return {strutShares(shape, columns), columns,
          scaleLegend("printed angle error", largest * kDegrees, "\u00b0")};
}

ColorShares barColors(const ShownGrid& shown, double BarState::*figure,
                      const std::function<Legend(double largest)>& legendOf) {
  const FramePlacement place{*shown.positions, *shown.rotations};
  StrutValues shares(shown.grid->shape);
  double largest = 0;
  forEachStrut(shown.grid->shape, [&](const Strut& strut) {
    double& value = valueAt(shares, strut);
    value = barStateAt(*shown.grid, place, strut).*figure;
    largest = std::max(largest, value);
  });
  return {dividedBy(std::move(shares), scaleOf(largest)), {}, legendOf(largest)};
}

Legend layerLegend(int layers) {
  return {"layer",
          [](double place) { return shareColor(static_cast<float>(place)); },
          {{0, "bottom", ""}, {1, fmt::format("top ({})", layers), ""}}};
}

}  // namespace

std::string whatIsMissing(Coloring coloring, const ShownGrid& shown, const Snapshot& snapshot) {
  if (coloring == Coloring::strain) {
    return "";
  }
  if (!shown.grid) {
    return "the grid itself is not there yet";
  }
  const int columnCount = shown.grid->shape.layerVertexCount();
  switch (coloring) {
    case Coloring::distance:
      return shown.positions && snapshot.targets && snapshot.targets->cols() == columnCount
                 ? ""
                 : "there is no target";
    case Coloring::bendingStrain:
    case Coloring::jointRotation:
      return shown.grid->bars && shown.positions && shown.rotations
                 ? ""
                 : "of welded bars alone (material.model)";
    case Coloring::angleError:
      return snapshot.angleErrors && snapshot.angleErrors->size() == columnCount
                 ? ""
                 : "of conformal sheets alone (design.layout)";
    default:
      return "";
  }
}

ColorShares computeColors(Coloring coloring, const ShownGrid& shown, const Snapshot& snapshot) {
  assert(coloring != Coloring::strain && canColor(coloring, shown, snapshot));
  const GridShape& shape = shown.grid->shape;
  switch (coloring) {
    case Coloring::shrink:
      return {computeShrinkShares(*shown.grid, snapshot.shrinkBounds), {}, shrinkLegend()};
    case Coloring::distance:
      return distanceColors(shown, *snapshot.targets);
    case Coloring::bendingStrain:
      return barColors(shown, &BarState::bendingStrain, [](double largest) {
        return scaleLegend("bending strain", 100 * largest, " %");
      });
    case Coloring::jointRotation:
      return barColors(shown, &BarState::jointRotation, [](double largest) {
        return scaleLegend("joint rotation", largest * kDegrees, "\u00b0");
      });
    case Coloring::angleError:
      return angleErrorColors(shape, *snapshot.angleErrors);
    default:
      return {layerShares(shape), {}, layerLegend(shape.layers)};
  }
}

}  // namespace morphgrid
