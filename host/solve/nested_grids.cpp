#include "solve/nested_grids.h"

#include <algorithm>
#include <cmath>

#include "solve/resample_grid.h"

namespace morphgrid {
namespace {

using Eigen::Matrix3Xd;

constexpr int kCoarsestNodes = 10;
// Squared, in cells: far less than between any two joints.
constexpr double kSamePlace = 1e-12;
// A coarse strut that should turn by more has no shape in common with those that it stands for.
constexpr double kLargestTurn = 1;
// From the finest to the next coarser grid; then by 2, which keeps the thickness per spacing.
constexpr double kFirstThickness = 1.4142135623730951;
// Rest lengths of the layers of one strut may differ by this share of their mean.
constexpr double kLargestLayerDifference = 0.35;
// Where corners weigh less than this share of the lateral struts' mean stiffness, the way from flat
// is long and winds. It begins with heavier ones, which get lighter by a factor at a time; from the
// last share to none.
constexpr double kLightCorner = 0.1;
constexpr double kCornerFactor = 10;
constexpr double kLightestCorner = 1e-5;

/// A grid's lines of struts along u or v: in each layer `count` of `struts` each.
struct StrutLines {
  GridShape shape;
  Strut::Direction along;

  bool isAlongU() const { return along == Strut::Direction::u; }
  int struts() const { return isAlongU() ? shape.cellsU() : shape.cellsV(); }
  int count() const { return isAlongU() ? shape.verticesV : shape.verticesU; }
  /// The n-th vertex of a line.
  int vertex(int n, int line, int layer) const {
    return isAlongU() ? shape.index(n, line, layer) : shape.index(line, n, layer);
  }
  /// visit(strut, n, line): it is the n-th strut of that line. From each line's start on.
  template <typename Visit>
  void forEachStrut(const Visit& visit) const {
    forEachLateralStrut(shape, [&](const Strut& strut) {
      if (strut.direction != along) return;
      const GridPlace from = shape.place(strut.from);
      visit(strut, isAlongU() ? from.i : from.j, isAlongU() ? from.j : from.i);
    });
  }
};

/// Sums of a value of lateral struts along their lines, from the line's start to any place.
class LineSums {
 public:
  LineSums(const StrutLines& lines, const std::vector<double>& values)
      : lines_(lines), sums_(static_cast<std::size_t>(lines.shape.vertexCount())) {
    lines.forEachStrut([&](const Strut& strut, int, int) {
      sums_[strut.to] = sums_[strut.from] + values[strut.from];
    });
  }

  /// Between two places along a line that may lie between lines.
  double between(double from, double to, double line, int layer) const {
    const LineStencil across = linearStencil(line, lines_.count());
    double sum = 0;
    for (int q = 0; q < across.count; ++q) {
      const int n = across.first + q;
      sum += across.weights[q] * (sumTo(to, n, layer) - sumTo(from, n, layer));
    }
    return sum;
  }

 private:
  double sumTo(double place, int line, int layer) const {
    const LineStencil along = linearStencil(place, lines_.struts() + 1);
    double sum = 0;
    for (int p = 0; p < along.count; ++p) {
      sum += along.weights[p] * sums_[lines_.vertex(along.first + p, line, layer)];
    }
    return sum;
  }

  StrutLines lines_;
  std::vector<double> sums_;  ///< One a vertex: that of its line up to there.
};

/// The rest lengths (or, as means, the stiffnesses) of a coarse grid's lateral struts.
std::vector<double> coarsenLateral(const GridShape& fine, const std::vector<double>& values,
                                   const GridShape& coarse, Strut::Direction along, bool mean) {
  const StrutLines from{fine, along};
  const StrutLines to{coarse, along};
  const LineSums sums(from, values);
  const double span = double(from.struts()) / to.struts();
  std::vector<double> result(coarse.vertexCount());
  to.forEachStrut([&](const Strut& strut, int n, int line) {
    const double sum = sums.between(n * span, (n + 1) * span,
                                    matchingPlace(line, to.count(), from.count()), strut.layer);
    result[strut.from] = mean ? sum / span : sum;
  });
  return result;
}

/// Vertical struts are those of the nearest column.
std::vector<double> coarsenVertical(const GridShape& fine, const std::vector<double>& values,
                                    const GridShape& coarse) {
  std::vector<double> result(coarse.vertexCount());
  for (int n = 0; n < coarse.vertexCount(); ++n) {
    result[n] = values[nearestVertex(coarse, n, fine)];
  }
  return result;
}

double meanOfLayers(const GridShape& shape, const std::vector<double>& values, int column) {
  double sum = 0;
  for (int k = 0; k < shape.layers; ++k) {
    sum += values[shape.index(column, k)];
  }
  return sum / shape.layers;
}

/// Scales how far the layers' rest lengths differ from their mean.
void spreadLayers(const GridShape& shape, std::vector<double>& rest, double factor) {
  for (int column = 0; column < shape.layerVertexCount(); ++column) {
    const double mean = meanOfLayers(shape, rest, column);
    for (int k = 0; k < shape.layers; ++k) {
      double& length = rest[shape.index(column, k)];
      length = mean + factor * (length - mean);
    }
  }
}

/// The largest difference between the rest lengths of two layers, as a share of their mean.
double largestLayerDifference(const GridShape& shape, const std::vector<double>& rest) {
  double largest = 0;
  for (int column = 0; column < shape.layerVertexCount(); ++column) {
    const double mean = meanOfLayers(shape, rest, column);
    if (mean == 0) continue;  // No strut.
    double shortest = mean, longest = mean;
    for (int k = 0; k < shape.layers; ++k) {
      const double length = rest[shape.index(column, k)];
      shortest = std::min(shortest, length);
      longest = std::max(longest, length);
    }
    largest = std::max(largest, (longest - shortest) / mean);
  }
  return largest;
}

/// The largest angle, in rad, that rest lengths make a strut turn by: the difference between the
/// top and the bottom layer's over their distance.
double largestTurn(const StrutGrid& grid) {
  const GridShape& shape = grid.shape;
  const int top = shape.layers - 1;
  double largest = 0;
  for (int column = 0; column < shape.layerVertexCount() && top > 0; ++column) {
    double distance = 0;
    for (int k = 0; k + 1 < shape.layers; ++k) {
      distance += grid.rest.w[shape.index(column, k)];
    }
    for (const auto* rest : {&grid.rest.u, &grid.rest.v}) {
      largest = std::max(largest,
                         std::abs((*rest)[shape.index(column, top)] - (*rest)[column]) / distance);
    }
  }
  return largest;
}

/// Forces are shared out among the coarse joints around them; those are held that lie nearest to
/// one that is.
JointLoads coarsened(const JointLoads& loads, const GridShape& fine, const GridShape& coarse) {
  JointLoads result{Matrix3Xd::Zero(3, coarse.vertexCount()), {}, loads.slide};
  forEachVertex(fine, [&](const GridPlace& place) {
    const LineStencil u =
        linearStencil(matchingPlace(place.i, fine.verticesU, coarse.verticesU), coarse.verticesU);
    const LineStencil v =
        linearStencil(matchingPlace(place.j, fine.verticesV, coarse.verticesV), coarse.verticesV);
    forEachWeight(u, v, [&](int i, int j, double weight) {
      result.forces.col(coarse.index(i, j, place.layer)) +=
          weight * loads.forces.col(fine.index(place));
    });
  });
  for (const int joint : loads.held) {
    result.held.push_back(nearestVertex(fine, joint, coarse));
  }
  std::sort(result.held.begin(), result.held.end());
  result.held.erase(std::unique(result.held.begin(), result.held.end()), result.held.end());
  return result;
}

StrutGrid coarsened(const StrutGrid& fine, const GridShape& shape) {
  using enum Strut::Direction;
  StrutGrid coarse{shape, 0, {}, StrutValues(shape), StrutValues(shape), fine.weights};
  coarse.spacing = fine.spacing * std::max(fine.shape.cellsU(), fine.shape.cellsV()) /
                   std::max(shape.cellsU(), shape.cellsV());
  coarse.rest.u = coarsenLateral(fine.shape, fine.rest.u, shape, u, false);
  coarse.rest.v = coarsenLateral(fine.shape, fine.rest.v, shape, v, false);
  coarse.rest.w = coarsenVertical(fine.shape, fine.rest.w, shape);
  coarse.stiffness.u = coarsenLateral(fine.shape, fine.stiffness.u, shape, u, true);
  coarse.stiffness.v = coarsenLateral(fine.shape, fine.stiffness.v, shape, v, true);
  coarse.stiffness.w = coarsenVertical(fine.shape, fine.stiffness.w, shape);
  return coarse;
}

/// One bar for as many as fit into its length side by side, as thick in spacings.
BarSection thickened(const BarSection& bar, double longer, double thickness) {
  const double bending = longer * thickness * thickness;
  return {longer * bar.stretching, bending * bar.bendingN, bending * bar.bendingB,
          bending * bar.twisting,  bar.shearing / longer,  thickness * bar.joint};
}

/// What bends the thicker grid as much: it is stiffer by the square.
JointLoads thickened(JointLoads loads, double thickness) {
  loads.forces *= thickness * thickness;
  return loads;
}

/// Moves the layers apart by wantedThickness, or as far as the rest lengths allow.
NestedGrid thickened(StrutGrid grid, const StrutGrid& finest, double wantedThickness) {
  const GridShape& shape = grid.shape;
  const double difference = std::max(largestLayerDifference(shape, grid.rest.u),
                                     largestLayerDifference(shape, grid.rest.v));
  const double thickness = difference * wantedThickness > kLargestLayerDifference
                               ? std::max(kLargestLayerDifference / difference, 1e-3)
                               : wantedThickness;
  spreadLayers(shape, grid.rest.u, thickness);
  spreadLayers(shape, grid.rest.v, thickness);
  for (double& length : grid.rest.w) {
    length *= thickness;
  }
  if (finest.bars) {
    const double longer = grid.spacing / finest.spacing;
    grid.bars = Bars{thickened(finest.bars->lateral, longer, thickness),
                     thickened(finest.bars->upright, longer, thickness),
                     resampleLayers(finest.shape, finest.bars->printed, shape, thickness)};
    if (finest.bars->loads) {
      grid.bars->loads = thickened(coarsened(*finest.bars->loads, finest.shape, shape), thickness);
    }
  }
  if (finest.printedCorners) {
    grid.printedCorners = resampleLayers(finest.shape, *finest.printedCorners, shape, thickness);
  }
  grid.positions = resampleLayers(finest.shape, finest.positions, shape, thickness);
  return {std::move(grid), thickness};
}

double meanLateralStiffness(const StrutGrid& grid) {
  double sum = 0;
  int count = 0;
  forEachLateralStrut(grid.shape, [&](const Strut& strut) {
    sum += valueAt(grid.stiffness, strut);
    ++count;
  });
  return sum / count;
}

/// Problems that differ from the last one by heavier and heavier corners.
void addHeavierCorners(std::vector<NestedGrid>& grids) {
  const double stiffness = meanLateralStiffness(grids.back().grid);
  while (grids.back().grid.weights.angle < kLightCorner * stiffness) {
    grids.push_back(grids.back());
    TermWeights& weights = grids.back().grid.weights;
    for (double* weight : {&weights.angle, &weights.postAngle}) {
      *weight = std::max(kCornerFactor * *weight, kLightestCorner * stiffness);
    }
  }
}

/// Joints that are held lie elsewhere on coarser grids. Moves them to where they are held, and all
/// others as smoothly as that goes (Shepard 1968): stiff supports would tear at them.
void moveToSupports(const StrutGrid& grid, Matrix3Xd& positions) {
  const std::vector<int>& held = grid.bars->loads->held;
  Matrix3Xd offsets = grid.bars->printed(Eigen::all, held) - positions(Eigen::all, held);
  if (grid.bars->loads->slide) {
    offsets.topRows<2>().setZero();
  }
  forEachVertex(grid.shape, [&](const GridPlace& place) {
    double weights = 0;
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    for (std::size_t n = 0; n < held.size(); ++n) {
      const GridPlace at = grid.shape.place(held[n]);
      const Eigen::Vector3d apart(at.i - place.i, at.j - place.j, at.layer - place.layer);
      const double weight = 1 / std::max(apart.squaredNorm(), kSamePlace);
      weights += weight;
      sum += weight * offsets.col(static_cast<Eigen::Index>(n));
    }
    positions.col(grid.shape.index(place)) += sum / weights;
  });
}

int halved(int vertices) { return std::max(1, vertices / 2) + 1; }

}  // namespace

std::vector<NestedGrid> nestGrids(const StrutGrid& finest) {
  std::vector<NestedGrid> grids{{finest, 1}};
  GridShape shape = finest.shape;
  while (std::max(shape.verticesU, shape.verticesV) - 1 > kCoarsestNodes) {
    shape = {halved(shape.verticesU), halved(shape.verticesV), shape.layers};
    StrutGrid coarse = coarsened(finest, shape);
    if (largestTurn(coarse) > kLargestTurn) {
      break;
    }
    const double factor = grids.size() == 1 ? kFirstThickness : 2;
    grids.push_back(thickened(std::move(coarse), finest, factor * grids.back().thickness));
  }
  if (!finest.bars) {
    addHeavierCorners(grids);
  }
  std::reverse(grids.begin(), grids.end());
  return grids;
}

Matrix3Xd prolong(const NestedGrid& coarse, const Matrix3Xd& positions, const NestedGrid& fine) {
  Matrix3Xd result = resampleLayers(coarse.grid.shape, positions, fine.grid.shape,
                                    fine.thickness / coarse.thickness);
  if (fine.grid.bars && fine.grid.bars->loads) {
    moveToSupports(fine.grid, result);
  }
  return result;
}

}  // namespace morphgrid
