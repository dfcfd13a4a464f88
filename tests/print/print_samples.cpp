#include "tests/print/print_samples.h"

#include <random>

#include "tests/support/folders.h"

namespace morphgrid {

Printer samplePrinter() { return readPrinter(sourceFolder() / "printers/prusa_mk4.toml"); }

PrintMaterial sampleMaterial() {
  return readPrintMaterial(sourceFolder() / "materials/pla_0.08.toml");
}

StrutGrid flatGrid(const GridShape& shape, double shrink) {
  StrutGrid grid{.shape = shape, .spacing = 1};
  grid.positions.resize(3, shape.vertexCount());
  forEachVertex(shape, [&](const GridPlace& place) {
    grid.positions.col(shape.index(place)) << place.i, place.j, 0.3 * place.layer;
  });
  grid.rest = StrutValues(shape);
  forEachStrut(shape, [&](const Strut& strut) {
    valueAt(grid.rest, strut) =
        strut.isLateral() ? (1 - shrink) * lengthAt(grid.positions, strut) : 0.3;
  });
  return grid;
}

StrutGrid randomGrid(const GridShape& shape, double low, double high, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> offset(-0.12, 0.12);
  std::uniform_real_distribution<double> shrink(low, high);
  StrutGrid grid = flatGrid(shape, 0);
  for (int column = 0; column < shape.layerVertexCount(); ++column) {
    const Eigen::Vector3d move(offset(generator), offset(generator), 0);
    for (int k = 0; k < shape.layers; ++k) grid.positions.col(shape.index(column, k)) += move;
  }
  forEachLateralStrut(shape, [&](const Strut& strut) {
    valueAt(grid.rest, strut) = (1 - shrink(generator)) * lengthAt(grid.positions, strut);
  });
  return grid;
}

}  // namespace morphgrid
