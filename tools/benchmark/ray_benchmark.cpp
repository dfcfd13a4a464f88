#include "benchmark/ray_benchmark.h"

#include <fmt/format.h>

#include <cmath>
#include <memory>
#include <nlohmann/json.hpp>
#include <numbers>
#include <optional>
#include <string>

#include "benchmark/cost.h"
#include "core/atomic_file.h"
#include "surface/mesh_ray_caster.h"

namespace morphgrid {
namespace {

struct RayBenchmark {
  int triangles = 1000000;
  int rays = 10000;
  int rounds = 9;
  std::string jsonFile;
};

/// A sphere around the origin, of radius 0.97 to 1.03.
TriangleMesh bumpySphere(int triangles) {
  const int rows = std::max(2, int(std::lround(std::sqrt(triangles / 4.0))));
  const int columns = 2 * rows;
  TriangleMesh mesh{Eigen::Matrix3Xd(3, columns * (rows + 1)),
                    Eigen::Matrix3Xi(3, 2 * columns * rows)};
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const double longitude = 2 * std::numbers::pi * i / columns;
      const double polar = std::numbers::pi * j / rows;
      const double radius = 1 + 0.03 * std::sin(12 * longitude) * std::sin(12 * polar);
      const int right = (i + 1) % columns;
      mesh.vertices.col(j * columns + i) =
          radius * Eigen::Vector3d(std::sin(polar) * std::cos(longitude),
                                   std::sin(polar) * std::sin(longitude), std::cos(polar));
      if (j < rows) {
        const int cell = 2 * (j * columns + i);
        const int below = (j + 1) * columns;
        mesh.triangles.col(cell) << j * columns + i, j * columns + right, below + right;
        mesh.triangles.col(cell + 1) << j * columns + i, below + right, below + i;
      }
    }
  }
  return mesh;
}

nlohmann::json printFigure(const char* title, const std::vector<Cost>& costs) {
  std::vector<double> wall;
  std::vector<double> cpu;
  for (const Cost& cost : costs) {
    wall.push_back(cost.wall);
    cpu.push_back(cost.cpu);
  }
  fmt::print("{:<24} {:>9.4f} {:>9.4f}\n", title, median(wall), median(cpu));
  return {{"wall_seconds", median(wall)}, {"cpu_seconds", median(cpu)}};
}

void run(const RayBenchmark& options) {
  const TriangleMesh mesh = bumpySphere(options.triangles);
  const int count = std::max(2, int(std::lround(std::sqrt(options.rays))));
  std::vector<Cost> build, inside, around;
  for (int round = 0; round < options.rounds; ++round) {
    std::optional<MeshRayCaster> caster;
    build.push_back(costOf([&] { caster.emplace(mesh); }));
    inside.push_back(costOf([&] { caster->cast({-0.65, -0.65, 1.3, 1.3}, count, count); }));
    around.push_back(costOf([&] { caster->cast({-1, -1, 2, 2}, count, count); }));
  }
  fmt::print("{} triangles, {} x {} rays: seconds, medians of {} rounds\n", mesh.triangles.cols(),
             count, count, options.rounds);
  fmt::print("{:<24} {:>9} {:>9}\n", "", "wall time", "CPU time");
  const nlohmann::json result{{"triangles", mesh.triangles.cols()},
                              {"rays", count * count},
                              {"build", printFigure("build the hierarchy", build)},
                              {"cast", printFigure("cast, all rays hit", inside)},
                              {"cast_with_misses", printFigure("cast, a quarter misses", around)}};
  if (!options.jsonFile.empty()) {
    writeFileAtomically(options.jsonFile, result.dump(2));
  }
}

}  // namespace

void addRayBenchmark(CLI::App& app) {
  const auto options = std::make_shared<RayBenchmark>();
  CLI::App* rays = app.add_subcommand(
      "rays", "Times building the hierarchy of a bumpy sphere and casting rays at it.");
  rays->add_option("--triangles", options->triangles, "of the sphere")
      ->check(CLI::Range(16, 100000000))
      ->capture_default_str();
  rays->add_option("--rays", options->rays, "in a square lattice")
      ->check(CLI::Range(4, 100000000))
      ->capture_default_str();
  rays->add_option("--rounds", options->rounds, "repetitions; medians are printed")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  rays->add_option("--json", options->jsonFile, "also write the figures to this file");
  rays->callback([options] { run(*options); });
}

}  // namespace morphgrid
