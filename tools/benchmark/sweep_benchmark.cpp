#include "benchmark/sweep_benchmark.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "benchmark/avx2_sweep.h"
#include "benchmark/coarse_costs.h"
#include "benchmark/cost.h"
#include "benchmark/kernel_costs.h"
#include "benchmark/problem.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "shared/solver_types.h"
#include "solve/jacobi_solver.h"

namespace morphgrid {
namespace {

struct SweepBenchmark {
  std::vector<int> sizes{10000, 250000};
  int rounds = 9;
  std::string device;
  std::string jsonFile;
};

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

void run(const SweepBenchmark& options) {
  if (!Avx2Sweep::isSupported()) {
    throw DeviceError("this processor has no AVX2: the peer cannot run");
  }
  const Device device({.selection = options.device, .validation = false});
  fmt::print(
      "device: {}\nnanoseconds per vertex of one sweep, and of multigrid's kernels; "
      "medians of {} rounds\n",
      device.name(), options.rounds);
  fmt::print("{:>8}  {:<16} {:>9} {:>6} {:>10} {:>6}\n", "vertices", "", "wall time", "ratio",
             "CPU time", "ratio");
  nlohmann::json results = nlohmann::json::array();
  for (const int size : options.sizes) {
    results.push_back(compareSweeps(device, size, options.rounds));
    printResult(results.back());
  }
  if (!options.jsonFile.empty()) {
    writeFileAtomically(options.jsonFile,
                        nlohmann::json{{"device", device.name()}, {"sweeps", results}}.dump(2));
  }
}

}  // namespace

void addSweepBenchmark(CLI::App& app) {
  const auto options = std::make_shared<SweepBenchmark>();
  CLI::App* sweep = app.add_subcommand("sweep",
                                       "Times one sweep of jacobi beside a hand-vectorised AVX2 "
                                       "loop, and multigrid's kernels one by one.");
  sweep->add_option("--vertices", options->sizes, "sizes of the grid, three layers")
      ->check(CLI::Range(12, 20000000))
      ->capture_default_str();
  sweep->add_option("--rounds", options->rounds, "repetitions; medians are printed")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  sweep->add_option("--device", options->device, "index or part of the name of a Vulkan device");
  sweep->add_option("--json", options->jsonFile, "also write the figures to this file");
  sweep->callback([options] { run(*options); });
}

}  // namespace morphgrid
