#include "tests/solve/frame_oracle.h"

#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "core/bounding_diagonal.h"
#include "core/rigid_alignment.h"
#include "grid/bar_section.h"
#include "tests/support/folders.h"

namespace morphgrid {
namespace {

double meanLateralRest(const StrutGrid& grid) {
  double sum = 0;
  forEachLateralStrut(grid.shape, [&](const Strut& strut) { sum += valueAt(grid.rest, strut); });
  return sum / grid.shape.lateralStrutCount();
}

StrutGrid flatGrid(const nlohmann::json& file) {
  const GridShape shape{file["shape"][0], file["shape"][1], file["shape"][2]};
  StrutGrid grid{shape,
                 file["spacing"],
                 Eigen::Matrix3Xd(3, shape.vertexCount()),
                 StrutValues(shape),
                 StrutValues(shape),
                 {}};
  const double layerSpacing = file["layerSpacing"];
  forEachVertex(shape, [&](const GridPlace& place) {
    const int column = shape.index(place.i, place.j, 0);
    grid.positions.col(shape.index(place)) << double(file["printed"][2 * column]),
        double(file["printed"][2 * column + 1]), layerSpacing * place.layer;
  });
  std::size_t n = 0;
  forEachStrut(shape, [&](const Strut& strut) {
    valueAt(grid.rest, strut) = file["rest"][n++];
    valueAt(grid.stiffness, strut) = 1;
  });
  return grid;
}

}  // namespace

FrameOracle loadFrameOracle(const std::string& name, double thickness) {
  std::ifstream stream(sourceFolder() / "tests/solve/frames" / (name + ".json"));
  const auto file = nlohmann::json::parse(stream);
  FrameOracle oracle{.grid = flatGrid(file), .energy = 0, .positions = {}};
  const double size = thickness * meanLateralRest(oracle.grid);
  const BarSection section =
      rectangularSection({.width = size, .height = size, .poisson = 0.45}, 1 / (size * size));
  oracle.grid.bars = Bars{section, section, oracle.grid.positions};
  for (const auto& equilibrium : file["equilibria"]) {
    if (equilibrium["thickness"] == thickness) {
      oracle.energy = equilibrium["energy"];
      const auto values = equilibrium["positions"].get<std::vector<double>>();
      oracle.positions = Eigen::Matrix3Xd::Map(values.data(), 3, values.size() / 3);
    }
  }
  return oracle;
}

Mismatch mismatchOf(const Eigen::Matrix3Xd& points, const Eigen::Matrix3Xd& others) {
  const Eigen::VectorXd distances =
      (alignRigidly(points, others) * points - others).colwise().norm();
  const double percent = 100 / boundingDiagonal(others);
  return {percent * std::sqrt(distances.squaredNorm() / distances.size()),
          percent * distances.maxCoeff()};
}

}  // namespace morphgrid
