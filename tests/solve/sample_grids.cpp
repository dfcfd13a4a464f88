#include "tests/solve/sample_grids.h"

#include <Eigen/Geometry>
#include <random>

#include "design/build_grids.h"

namespace morphgrid {

StrutGrid bentGrid(const GridShape& shape, unsigned seed) {
  constexpr double kLayerSpacing = 0.3;
  StrutGrid grid{
      shape, 1.0, Eigen::Matrix3Xd(3, shape.vertexCount()), StrutValues(shape), StrutValues(shape),
      {}};
  for (int k = 0; k < shape.layers; ++k) {
    for (int j = 0; j < shape.verticesV; ++j) {
      for (int i = 0; i < shape.verticesU; ++i) {
        grid.positions.col(shape.index(i, j, k)) = Eigen::Vector3d(i, j, kLayerSpacing * k);
      }
    }
  }
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> percent(-0.03, 0.03);
  forEachStrut(shape, [&](const Strut& strut) {
    const bool vertical = strut.direction == Strut::Direction::w;
    const double bend = strut.direction == Strut::Direction::u ? 0.05 : -0.03;
    valueAt(grid.rest, strut) =
        vertical ? kLayerSpacing : 0.9 - bend * strut.layer + percent(random);
    valueAt(grid.stiffness, strut) = vertical ? 40 : 5;
  });
  return grid;
}

StrutGrid withPrintedCorners(StrutGrid grid) {
  const GridShape& shape = grid.shape;
  Eigen::Matrix3Xd printed(3, shape.vertexCount());
  forEachVertex(shape, [&](const GridPlace& at) {
    const double slant = 0.25 + 0.15 * at.i / shape.verticesU;
    printed.col(shape.index(at)) << at.i + slant * at.j, at.j, at.layer;
  });
  grid.printedCorners = std::move(printed);
  return grid;
}

Eigen::Matrix3Xd shaken(const Eigen::Matrix3Xd& positions, double amount, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> offset(-amount, amount);
  return positions.unaryExpr([&](double x) { return x + offset(random); });
}

StrutGrid circularStrip(int nodes, int layers, double theta, double layerSpacing) {
  const GridDesign design =
      designFromBendAngles({nodes, 2, 1.0, theta, theta, 0, 0}, layers, layerSpacing);
  const Weights weights;
  return stackedGrid(design, weights, Scaling::normalised,
                     inPlaneGrid(design, weights, Scaling::normalised).positions);
}

double stripRadius(const GridShape& shape, const Eigen::Matrix3Xd& positions) {
  const auto at = [&](int i) -> Eigen::Vector3d { return positions.col(shape.index(i, 1, 0)); };
  const Eigen::Vector3d a = at(4) - at(10);
  const Eigen::Vector3d b = at(16) - at(10);
  return a.norm() * b.norm() * (a - b).norm() / (2 * a.cross(b).norm());
}

}  // namespace morphgrid
