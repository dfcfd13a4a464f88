#include "benchmark/profile_benchmark.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "benchmark/problem.h"
#include "benchmark/solve_run.h"
#include "core/atomic_file.h"
#include "gpu/kernel_profile.h"

namespace morphgrid {
namespace {

struct ProfileBenchmark {
  std::string scene;
  int cup = 100;
  std::string device;
  std::string jsonFile;
};

using NamedShare = std::pair<std::string, KernelProfile::Share>;

/// What takes longest first.
std::vector<NamedShare> sorted(const KernelProfile& profile) {
  std::vector<NamedShare> kernels(profile.kernels().begin(), profile.kernels().end());
  std::sort(kernels.begin(), kernels.end(), [](const NamedShare& a, const NamedShare& b) {
    return a.second.seconds > b.second.seconds;
  });
  return kernels;
}

/// Seconds that are not any kernel's.
struct Rest {
  double submissions;  ///< The host waited, but no kernel ran.
  double host;         ///< The host did not wait.
};

Rest restOf(const KernelProfile& profile, double wall) {
  double kernels = 0;
  for (const auto& [name, share] : profile.kernels()) {
    kernels += share.seconds;
  }
  return {profile.submissions().seconds - kernels, wall - profile.submissions().seconds};
}

void print(const KernelProfile& profile, double wall, int vertices) {
  fmt::print("{:<30} {:>8} {:>10} {:>8} {:>14} {:>12}\n", "kernel", "calls", "ms", "share",
             "ns per vertex", "us per call");
  const auto row = [&](const std::string& name, long calls, double seconds) {
    fmt::print("{:<30} {:>8} {:>10.1f} {:>6.1f} % {:>14.1f} {:>12.1f}\n", name, calls,
               1e3 * seconds, 100 * seconds / wall, 1e9 * seconds / vertices,
               1e6 * seconds / static_cast<double>(calls));
  };
  for (const auto& [name, share] : sorted(profile)) {
    row(name, share.calls, share.seconds);
  }
  const Rest rest = restOf(profile, wall);
  row("submissions, beyond kernels", profile.submissions().calls, rest.submissions);
  row("host", 1, rest.host);
  row("whole solve", 1, wall);
}

nlohmann::json toJson(const KernelProfile& profile, double wall) {
  nlohmann::json json;
  for (const auto& [name, share] : profile.kernels()) {
    json["kernels"][name] = {{"calls", share.calls}, {"seconds", share.seconds}};
  }
  const Rest rest = restOf(profile, wall);
  json["submissions"] = {{"calls", profile.submissions().calls}, {"seconds", rest.submissions}};
  json["host_seconds"] = rest.host;
  json["seconds"] = wall;
  return json;
}

void run(const ProfileBenchmark& options) {
  const Problem problem =
      options.scene.empty() ? cupProblem(options.cup) : sceneProblem(options.scene);
  const Device device({.selection = options.device, .profile = true});
  const StrutGrid grid = problem.stacked(runMultigrid(device, problem.inPlane()).positions);
  runMultigrid(device, grid);  // Compiles and warms up.
  device.profile()->clear();
  const SolveRun solve = runMultigrid(device, grid);
  const int vertices = grid.shape.vertexCount();
  fmt::print("device: {}\n{}: {} vertices, full stage by multigrid, {} V-cycles\n", device.name(),
             problem.name, vertices, solve.iterations());
  print(*device.profile(), solve.cost.wall, vertices);
  if (!options.jsonFile.empty()) {
    nlohmann::json json = toJson(*device.profile(), solve.cost.wall);
    json.update({{"device", device.name()},
                 {"name", problem.name},
                 {"vertices", vertices},
                 {"cycles", solve.iterations()}});
    writeFileAtomically(options.jsonFile, json.dump(2));
  }
}

}  // namespace

void addProfileBenchmark(CLI::App& app) {
  const auto options = std::make_shared<ProfileBenchmark>();
  CLI::App* profile =
      app.add_subcommand("profile", "Shows where the time of a solve by multigrid goes.");
  CLI::Option* scene =
      profile->add_option("scene", options->scene, "name of a scene, or a file that ends in .toml");
  profile->add_option("--cup", options->cup, "the cup, with so many nodes on its long edge")
      ->check(CLI::Range(4, 20000))
      ->excludes(scene)
      ->capture_default_str();
  profile->add_option("--device", options->device, "index or part of the name of a Vulkan device");
  profile->add_option("--json", options->jsonFile, "also write the figures to this file");
  profile->callback([options] { run(*options); });
}

}  // namespace morphgrid
