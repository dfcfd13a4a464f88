#include "benchmark/problem.h"

#include <fmt/format.h>

#include <cmath>
#include <filesystem>

#include "app/design_scene.h"

namespace morphgrid {
namespace {

/// In the scene's unit of length: layer spacing times nodes, see scenes/cup.toml.
constexpr double kCupThickness = 18.9;

Problem designed(std::string name, const Scene& scene) {
  SceneDesign design = designScene(scene);
  Problem problem{std::move(name), std::move(design.design), scene.weights, scene.scaling};
  if (design.sheet) {
    problem.sheet = std::move(design.sheet->sheet);
  }
  return problem;
}

Problem cupOf(int nodesLong, std::vector<std::string> overrides) {
  overrides.push_back(fmt::format("grid.nodes_long={}", nodesLong));
  overrides.push_back(fmt::format("grid.layer_spacing={}", kCupThickness / nodesLong));
  return designed(fmt::format("cup {}", nodesLong), loadScene(sceneFile("cup"), overrides));
}

}  // namespace

std::filesystem::path checkoutFolder() {
  return std::filesystem::path(MORPHGRID_SCENES).parent_path();
}

std::filesystem::path sceneFile(const std::string& nameOrFile) {
  const std::filesystem::path path = nameOrFile;
  return path.extension() == ".toml"
             ? path
             : std::filesystem::path(MORPHGRID_SCENES) / (nameOrFile + ".toml");
}

Problem sceneProblem(const std::string& nameOrFile) {
  const Scene scene = loadScene(sceneFile(nameOrFile));
  return designed(scene.name, scene);
}

Problem cupProblem(int nodesLong) { return cupOf(nodesLong, {}); }

Problem weldedCupProblem(int nodesLong) { return cupOf(nodesLong, {"material.model=frame"}); }

StrutGrid saddleGrid(int vertexCount) {
  constexpr int kLayers = 3;
  constexpr double kTau = 0.35;
  const int edge = static_cast<int>(std::lround(std::sqrt(double(vertexCount) / kLayers)));
  StrutGrid grid{{edge, edge, kLayers}, 1.0, {}, {}, {}, {}};
  const GridShape& shape = grid.shape;
  grid.positions.resize(3, shape.vertexCount());
  grid.rest = StrutValues(shape);
  grid.stiffness = StrutValues(shape);
  forEachVertex(shape, [&](const GridPlace& place) {
    grid.positions.col(shape.index(place)) = Eigen::Vector3d(place.i, place.j, kTau * place.layer);
  });
  forEachStrut(shape, [&](const Strut& strut) {
    const bool vertical = strut.direction == Strut::Direction::w;
    const double sign = strut.direction == Strut::Direction::u ? 1 : -1;
    valueAt(grid.rest, strut) = vertical ? kTau : 0.9 + 0.02 * sign * strut.layer;
    valueAt(grid.stiffness, strut) = vertical ? 40 : 5;
  });
  return grid;
}

}  // namespace morphgrid
