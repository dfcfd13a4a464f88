#include "benchmark/solve_benchmark.h"

#include <fmt/format.h>

#include <memory>

#include "benchmark/solve_report.h"
#include "core/atomic_file.h"

namespace morphgrid {
namespace {

constexpr int kWarmUpNodes = 100;
constexpr int kWarmUpVertices = 50000;

struct SolveBenchmark {
  std::vector<std::string> scenes;
  std::vector<int> cups;
  ComparisonOptions comparison;
  std::string device;
  std::string jsonFile;
  std::string plotFile;
};

std::vector<Problem> problemsOf(SolveBenchmark options) {
  if (options.scenes.empty() && options.cups.empty()) {
    options.scenes = {"egg_chair", "iris_petal"};
    options.cups = {100, 200, 630};
  }
  std::vector<Problem> problems;
  for (const std::string& scene : options.scenes) {
    problems.push_back(sceneProblem(scene));
  }
  for (const int nodes : options.cups) {
    problems.push_back(cupProblem(nodes));
  }
  return problems;
}

/// Compiles the kernels: a first solve is not what is measured. Large grids share those of a cup.
void warmUp(const Device& device, const std::vector<Problem>& problems) {
  for (const Problem& problem : problems) {
    const GridDesign& design = problem.design;
    const bool isLarge = design.nodesU * design.nodesV * design.layers > kWarmUpVertices;
    const Problem chosen = isLarge ? cupProblem(kWarmUpNodes) : problem;
    runMultigrid(device, chosen.stacked(runMultigrid(device, chosen.inPlane()).positions));
  }
}

/// Better now than after an hour.
void requireWritable(const std::string& file) {
  if (!file.empty()) {
    writeFileAtomically(file, "");
  }
}

/// After every problem: who loses patience keeps what there is.
void writeResults(const SolveBenchmark& options, const Device& device,
                  const std::vector<Comparison>& results) {
  if (!options.jsonFile.empty()) {
    nlohmann::json json{{"device", device.name()}, {"solves", nlohmann::json::array()}};
    for (const Comparison& result : results) {
      json["solves"].push_back(toJson(result));
    }
    writeFileAtomically(options.jsonFile, json.dump(1));
  }
  if (!options.plotFile.empty()) {
    writeFileAtomically(options.plotFile, drawTimes(results));
  }
}

void run(const SolveBenchmark& options) {
  const std::vector<Problem> problems = problemsOf(options);
  const Device device({.selection = options.device, .validation = false});
  requireWritable(options.jsonFile);
  requireWritable(options.plotFile);
  fmt::print(
      "device: {}\nwhole solves, from flat; medians; \"the energy\" is within {:g} of the least "
      "that any method reached\n",
      device.name(), kEnergyError);
  warmUp(device, problems);
  std::vector<Comparison> results;
  for (const Problem& problem : problems) {
    results.push_back(compareMethods(device, problem, options.comparison));
    fmt::print("\n{}", describe(results.back()));
    std::fflush(stdout);
    writeResults(options, device, results);
  }
  fmt::print("\n{}", describeGrowth(results));
}

}  // namespace

void addSolveBenchmark(CLI::App& app) {
  const auto options = std::make_shared<SolveBenchmark>();
  ComparisonOptions& comparison = options->comparison;
  CLI::App* solve = app.add_subcommand(
      "solve", "Times whole solves, from flat to equilibrium, multigrid beside its peers.");
  solve->add_option("--scenes", options->scenes,
                    "names of scenes, or files that end in .toml (default: egg_chair iris_petal, "
                    "unless --cup is given)");
  solve
      ->add_option("--cup", options->cups,
                   "cups with so many nodes on the long edge (default: 100 200 630, unless "
                   "--scenes is given)")
      ->check(CLI::Range(4, 20000));
  solve->add_option("--methods", comparison.methods, "of multigrid, reference and jacobi")
      ->check(CLI::IsMember({"multigrid", "reference", "jacobi"}))
      ->capture_default_str();
  solve
      ->add_option("--rounds", comparison.rounds,
                   "solves of which the median counts; fewer where they take long")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  solve
      ->add_option("--peer-seconds", comparison.peerLimit,
                   "after which a solve by reference or jacobi is cut short")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  solve->add_option("--device", options->device, "index or part of the name of a Vulkan device");
  solve->add_option("--json", options->jsonFile, "also write the figures to this file");
  solve->add_option("--plot", options->plotFile,
                    "also draw time over vertices to this file, as SVG");
  solve->callback([options] { run(*options); });
}

}  // namespace morphgrid
