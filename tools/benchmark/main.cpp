#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <chrono>
#include <cmath>
#include <iostream>
#include <nlohmann/json.hpp>

#include "benchmark/avx2_sweep.h"
#include "core/atomic_file.h"
#include "shared/solver_types.h"
#include "solve/jacobi_solver.h"

namespace morphgrid {
namespace {

using Clock = std::chrono::steady_clock;

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

double median(std::vector<double> values) {
  std::nth_element(values.begin(), values.begin() + values.size() / 2, values.end());
  return values[values.size() / 2];
}

template <typename Work>
double secondsOf(Work work) {
  const auto start = Clock::now();
  work();
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Median times of one sweep, the competitors taking turns so that a noisy neighbour meets all.
nlohmann::json compareSweeps(const Device& device, int vertexCount, int rounds) {
  const StrutGrid grid = saddleGrid(vertexCount);
  DeviceGrid deviceGrid(device, grid);
  JacobiSolver solver(device, grid, deviceGrid);
  Avx2Sweep peer(grid);
  const int checks = std::clamp(400000 / grid.shape.vertexCount(), 1, 16);
  const int sweeps = checks * static_cast<int>(kSweepsPerCheck);
  std::vector<double> single, precise, native;
  for (int round = 0; round <= rounds; ++round) {
    const double singleSeconds = secondsOf([&] { solver.sweep(checks); });
    const double preciseSeconds =
        device.hasFloat64() ? secondsOf([&] { solver.sweep(checks, true); }) : NAN;
    const double nativeSeconds = secondsOf([&] { peer.run(sweeps); });
    if (round > 0) {  // The first one warms up.
      single.push_back(singleSeconds / sweeps);
      precise.push_back(preciseSeconds / sweeps);
      native.push_back(nativeSeconds / sweeps);
    }
  }
  const double perVertex = 1e9 / grid.shape.vertexCount();
  return {{"vertices", grid.shape.vertexCount()},
          {"native_avx2_ns_per_vertex", median(native) * perVertex},
          {"device_ns_per_vertex", median(single) * perVertex},
          {"device_precise_ns_per_vertex", median(precise) * perVertex},
          {"ratio", median(single) / median(native)},
          {"ratio_precise", median(precise) / median(native)}};
}

int runBenchmark(int argc, char** argv) {
  CLI::App app(
      "Measures one sweep of the jacobi method on the device beside a hand-vectorised AVX2 loop.");
  std::vector<int> sizes{10000, 250000};
  std::string selection;
  std::string jsonFile;
  int rounds = 9;
  app.add_option("--vertices", sizes, "grid sizes")->capture_default_str();
  app.add_option("--rounds", rounds, "repetitions; medians are printed")->capture_default_str();
  app.add_option("--device", selection, "index or part of the name of a Vulkan device");
  app.add_option("--json", jsonFile, "also write the figures to this file");
  CLI11_PARSE(app, argc, argv);
  if (!Avx2Sweep::isSupported()) {
    std::cerr << "bench: this processor has no AVX2: the peer cannot run\n";
    return 4;
  }
  const Device device({.selection = selection, .validation = false});
  fmt::print("device: {}\nwall time of a sweep per vertex, medians of {} rounds\n", device.name(),
             rounds);
  fmt::print("{:>10} {:>14} {:>12} {:>8} {:>18} {:>8}\n", "vertices", "AVX2, 2 threads", "device",
             "ratio", "device, precise", "ratio");
  nlohmann::json results = nlohmann::json::array();
  for (const int size : sizes) {
    const auto result = compareSweeps(device, size, rounds);
    fmt::print("{:>10} {:>12.1f} ns {:>9.1f} ns {:>8.2f} {:>15.1f} ns {:>8.2f}\n",
               result["vertices"].get<int>(), result["native_avx2_ns_per_vertex"].get<double>(),
               result["device_ns_per_vertex"].get<double>(), result["ratio"].get<double>(),
               result["device_precise_ns_per_vertex"].get<double>(),
               result["ratio_precise"].get<double>());
    results.push_back(result);
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
