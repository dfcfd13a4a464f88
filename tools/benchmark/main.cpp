#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <functional>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "benchmark/avx2_sweep.h"
#include "benchmark/coarse_costs.h"
#include "benchmark/cost.h"
#include "benchmark/kernel_costs.h"
#include "benchmark/ray_benchmark.h"
#include "core/atomic_file.h"
#include "shared/solver_types.h"
#include "solve/jacobi_solver.h"

namespace morphgrid {
namespace {

/// A flat three-layer grid whose struts want to bend it into a saddle.
StrutGrid saddleGrid(int vertexCount) {
  constexpr int kLayers = 3;
  constexpr double kTau = 0.35;
  const int edge = static_cast<int>(std::lround(std::sqrt(double(vertexCount) / kLayers)));
  StrutGrid grid{{edge, edge, kLayers}, 1.0, {}, {}, {}, 1.0};
  const GridShape& shape = grid.shape;
  grid.positions.resize(3, shape.vertexCount());
  grid.rest = StrutValues(shape);
  grid.stiffness = StrutValues(shape);
  for (int k = 0; k < kLayers; ++k) {
    for (int j = 0; j < edge; ++j) {
      for (int i = 0; i < edge; ++i) {
        grid.positions.col(shape.index(i, j, k)) = Eigen::Vector3d(i, j, kTau * k);
      }
    }
  }
  for (const Strut& strut : listStruts(shape)) {
    const bool vertical = strut.direction == Strut::Direction::w;
    const double sign = strut.direction == Strut::Direction::u ? 1 : -1;
    valueAt(grid.rest, strut) = vertical ? kTau : 0.9 + 0.02 * sign * strut.layer;
    valueAt(grid.stiffness, strut) = vertical ? 40 : 5;
  }
  return grid;
}

/// One way to sweep, measured round after round.
struct Competitor {
  std::string name;  ///< Also the key in the file of results.
  std::function<void(int)> sweep;
  std::vector<double> wall = {}, cpu = {};  ///< Nanoseconds per sweep and vertex.
};

/// The competitors take turns so that a noisy neighbour meets all.
void measure(std::vector<Competitor>& competitors, int vertexCount, int rounds) {
  const int sweeps = std::clamp(4000000 / vertexCount, 16, 256) / 16 * 16;
  const double toNanoseconds = 1e9 / (double(sweeps) * vertexCount);
  for (int round = 0; round <= rounds; ++round) {
    for (Competitor& competitor : competitors) {
      const Cost cost = costOf([&] { competitor.sweep(sweeps); });
      if (round > 0) {  // The first one compiles and warms up.
        competitor.wall.push_back(cost.wall * toNanoseconds);
        competitor.cpu.push_back(cost.cpu * toNanoseconds);
      }
    }
  }
}

/// Median costs of one sweep, and their ratios to the first competitor's.
nlohmann::json compareSweeps(const Device& device, int vertexCount, int rounds) {
  const StrutGrid grid = saddleGrid(vertexCount);
  DeviceGrid deviceGrid(device, grid);
  JacobiSolver solver(device, grid, deviceGrid);
  Avx2Sweep peer(grid);
  std::vector<Competitor> competitors{{"native_avx2", [&](int count) { peer.run(count); }},
                                      {"device", [&](int count) { solver.sweep(count); }}};
  if (device.hasFloat64()) {
    competitors.push_back({"device_precise", [&](int count) { solver.sweep(count, true); }});
  }
  measure(competitors, grid.shape.vertexCount(), rounds);
  nlohmann::json kernels = measureKernels(device, grid, rounds);
  kernels.update(measureCoarseLevels(device, grid, rounds));
  nlohmann::json result{{"vertices", grid.shape.vertexCount()}, {"kernels", std::move(kernels)}};
  for (const Competitor& competitor : competitors) {
    const double wall = median(competitor.wall);
    const double cpu = median(competitor.cpu);
    result[competitor.name] = {{"wall_ns_per_vertex", wall},
                               {"cpu_ns_per_vertex", cpu},
                               {"wall_ratio", wall / median(competitors[0].wall)},
                               {"cpu_ratio", cpu / median(competitors[0].cpu)}};
  }
  return result;
}

void printResult(const nlohmann::json& result) {
  for (const auto& [key, title] :
       {std::pair{"native_avx2", "AVX2, 2 threads"}, std::pair{"device", "device"},
        std::pair{"device_precise", "device, doubles"}}) {
    if (!result.contains(key)) {
      continue;
    }
    const auto figure = [&](const char* name) { return result[key][name].template get<double>(); };
    fmt::print("{:>8}  {:<16} {:>9.1f} {:>6.2f} {:>10.1f} {:>6.2f}\n",
               result["vertices"].get<int>(), title, figure("wall_ns_per_vertex"),
               figure("wall_ratio"), figure("cpu_ns_per_vertex"), figure("cpu_ratio"));
  }
  printKernels(result["kernels"]);
}

int runBenchmark(int argc, char** argv) {
  CLI::App app(
      "Measures one sweep of the jacobi method on the device beside a hand-vectorised AVX2 loop.");
  std::vector<int> sizes{10000, 250000};
  std::string selection;
  std::string jsonFile;
  int rounds = 9;
  app.add_option("--vertices", sizes, "grid sizes")
      ->check(CLI::Range(12, 20000000))
      ->capture_default_str();
  app.add_option("--rounds", rounds, "repetitions; medians are printed")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  app.add_option("--device", selection, "index or part of the name of a Vulkan device");
  app.add_option("--json", jsonFile, "also write the figures to this file");
  addRayBenchmark(app);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? 0 : 2;
  }
  if (app.got_subcommand("rays")) {
    return 0;
  }
  if (!Avx2Sweep::isSupported()) {
    std::cerr << "bench: this processor has no AVX2: the peer cannot run\n";
    return 4;
  }
  const Device device({.selection = selection, .validation = false});
  fmt::print(
      "device: {}\nnanoseconds per vertex of one sweep, and of multigrid's kernels; "
      "medians of {} rounds\n",
      device.name(), rounds);
  fmt::print("{:>8}  {:<16} {:>9} {:>6} {:>10} {:>6}\n", "vertices", "", "wall time", "ratio",
             "CPU time", "ratio");
  nlohmann::json results = nlohmann::json::array();
  for (const int size : sizes) {
    results.push_back(compareSweeps(device, size, rounds));
    printResult(results.back());
  }
  if (!jsonFile.empty()) {
    writeFileAtomically(jsonFile,
                        nlohmann::json{{"device", device.name()}, {"sweeps", results}}.dump(2));
  }
  return 0;
}

}  // namespace
}  // namespace morphgrid

int main(int argc, char** argv) {
  try {
    return morphgrid::runBenchmark(argc, argv);
  } catch (const std::exception& error) {
    std::cerr << "bench: " << error.what() << "\n";
    return 4;
  }
}
