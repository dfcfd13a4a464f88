#include "benchmark/run_benchmark.h"

#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <nlohmann/json.hpp>

#include "benchmark/child_process.h"
#include "benchmark/cost.h"
#include "benchmark/problem.h"
#include "benchmark/work_folder.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "core/read_file.h"
#include "report/generated_block.h"

namespace morphgrid {
namespace {

namespace fs = std::filesystem;

/// Not converged: the results are written all the same.
constexpr int kMostExitCode = 3;
/// Kernels of larger grids are those of this cup.
constexpr int kWarmUpNodes = 100;
constexpr const char* kTableHead =
    "| | | wall, s | of it solves, s | CPU, s | memory, MB | files, MB |\n"
    "| --- | --- | --- | --- | --- | --- | --- |\n";

using Arguments = std::vector<std::string>;

struct RunBenchmark {
  std::vector<std::string> scenes{"egg_chair", "egg_chair_true", "face_true"};
  std::vector<int> cups{200, 630};
  fs::path program = fs::read_symlink("/proc/self/exe").parent_path() / "../morphgrid";
  fs::path beside;
  int rounds = 5;
  double seconds = 60;
  std::string document;
};

/// A call of the program, and what of the driver's cache it finds.
struct RunCase {
  std::string name;
  Arguments arguments;  ///< But for the folder of its results.
  bool writes = true;
  bool isFirst = false;  ///< With an empty cache.
};

struct RunFigures {
  double wall = 0, solves = 0, cpu = 0;  ///< Seconds.
  double memory = 0, files = 0;          ///< Megabytes.
};

Arguments with(Arguments arguments, const Arguments& settings) {
  for (const std::string& setting : settings) {
    arguments.insert(arguments.end(), {"--set", setting});
  }
  return arguments;
}

const Arguments kNoPictures{"output.pictures=false"};
const Arguments kNoOutputs{"output.pictures=false", "output.gltf=false", "output.vtu=false",
                           "output.ply=false",      "output.obj=false",  "output.state=false"};

std::vector<RunCase> casesOf(const std::string& scene) {
  const Arguments run{"run", sceneFile(scene), "--quiet"};
  const std::string name = fs::path(scene).stem();
  return {{name, run},
          {name + ", no pictures", with(run, kNoPictures)},
          {name + ", kernels not compiled yet", run, true, true}};
}

std::vector<RunCase> casesOf(int nodes) {
  const std::string cup = sceneFile("cup");
  const std::string size = fmt::format("grid.nodes_long={}", nodes);
  const Arguments run = with({"run", cup, "--quiet"}, {size});
  const std::string name = fmt::format("cup, N = {}", nodes);
  return {{name, run},
          {name + ", no outputs", with(run, kNoOutputs)},
          {name + ", `check`", with({"check", cup}, {size}), false}};
}

double megabytesIn(const fs::path& folder) {
  double bytes = 0;
  for (const auto& entry : fs::directory_iterator(folder)) {
    bytes += static_cast<double>(entry.file_size());
  }
  return bytes / 1e6;
}

double secondsOfSolves(const fs::path& report) {
  const nlohmann::json json = nlohmann::json::parse(readFile(report));
  double seconds = 0;
  for (const char* stage : {"in_plane", "full"}) {
    if (json.contains(stage) && json[stage].contains("seconds")) {
      seconds += json[stage]["seconds"].get<double>();
    }
  }
  return seconds;
}

void empty(const fs::path& folder) {
  fs::remove_all(folder);
  fs::create_directories(folder);
}

RunFigures measureOnce(const fs::path& program, const RunCase& one, const fs::path& folder) {
  const fs::path results = folder / "results";
  const fs::path cache = folder / (one.isFirst ? "empty_cache" : "cache");
  empty(results);
  if (one.isFirst) empty(cache);
  Arguments arguments{fmt::format("MESA_SHADER_CACHE_DIR={}", cache.string()), program};
  arguments.insert(arguments.end(), one.arguments.begin(), one.arguments.end());
  if (one.writes) arguments.insert(arguments.end(), {"--out", results});
  const double start = costSoFar().wall;
  ChildProcess child("/usr/bin/env", arguments, folder / "output");
  const int exitCode = child.exitCode();
  RunFigures figures{.wall = costSoFar().wall - start,
                     .cpu = child.cost().cpuSeconds,
                     .memory = child.cost().peakMegabytes,
                     .files = megabytesIn(results)};
  if (exitCode > kMostExitCode) {
    throw std::runtime_error(
        fmt::format("{} ended with {}:\n{}", program.string(), exitCode, child.output()));
  }
  if (one.writes) figures.solves = secondsOfSolves(results / "report.json");
  return figures;
}

RunFigures mediansOf(const std::vector<RunFigures>& runs) {
  const auto of = [&](double RunFigures::*figure) {
    std::vector<double> values;
    for (const RunFigures& run : runs) values.push_back(run.*figure);
    return median(std::move(values));
  };
  return {of(&RunFigures::wall), of(&RunFigures::solves), of(&RunFigures::cpu),
          of(&RunFigures::memory), of(&RunFigures::files)};
}

/// One after the other of the programs in each round: medians of each.
std::vector<RunFigures> takeTurns(const std::vector<fs::path>& programs, const RunCase& one,
                                  const RunBenchmark& options, const fs::path& folder) {
  std::vector<std::vector<RunFigures>> runs(programs.size());
  const double start = costSoFar().wall;
  for (int round = 0; round < options.rounds; ++round) {
    if (round > 0 && costSoFar().wall - start > options.seconds) break;
    for (std::size_t n = 0; n < programs.size(); ++n) {
      runs[n].push_back(measureOnce(programs[n], one, folder));
    }
  }
  std::vector<RunFigures> medians;
  for (const auto& ofProgram : runs) medians.push_back(mediansOf(ofProgram));
  return medians;
}

std::string rowOf(const std::string& name, const char* build, const RunFigures& figures) {
  return fmt::format("| {} | {} | {:.3g} | {:.3g} | {:.3g} | {:.0f} | {:.3g} |\n", name, build,
                     figures.wall, figures.solves, figures.cpu, figures.memory, figures.files);
}

std::string ratioRow(const RunFigures& figures, const RunFigures& beside) {
  const auto ratio = [&](double RunFigures::*figure) {
    return beside.*figure > 0 ? fmt::format("{:.2f}", figures.*figure / (beside.*figure)) : "";
  };
  return fmt::format("| | ratio | {} | {} | {} | {} | {} |\n", ratio(&RunFigures::wall),
                     ratio(&RunFigures::solves), ratio(&RunFigures::cpu),
                     ratio(&RunFigures::memory), ratio(&RunFigures::files));
}

std::string rowsOf(const std::string& name, const std::vector<RunFigures>& figures) {
  std::string rows = rowOf(name, "this build", figures.front());
  if (figures.size() > 1) {
    rows += rowOf("", "the other", figures.back()) + ratioRow(figures.front(), figures.back());
  }
  return rows;
}

std::vector<RunCase> allCases(const RunBenchmark& options) {
  std::vector<RunCase> cases;
  const auto add = [&](const std::vector<RunCase>& more) {
    cases.insert(cases.end(), more.begin(), more.end());
  };
  for (const std::string& scene : options.scenes) add(casesOf(scene));
  for (const int nodes : options.cups) add(casesOf(nodes));
  return cases;
}

/// The driver's cache then holds the kernels of all cases.
void compileKernels(const RunBenchmark& options, const fs::path& program, const fs::path& folder) {
  std::vector<RunCase> cases;
  for (const std::string& scene : options.scenes) cases.push_back(casesOf(scene).front());
  if (!options.cups.empty()) cases.push_back(casesOf(kWarmUpNodes).front());
  for (const RunCase& one : cases) measureOnce(program, one, folder);
}

void run(const RunBenchmark& options) {
  if (!options.document.empty()) {  // Better now than when all is done.
    withBlock(readFile(options.document), "run", "");
  }
  const WorkFolder folder;
  std::vector<fs::path> programs{options.program};
  if (!options.beside.empty()) programs.push_back(options.beside);
  for (const fs::path& program : programs) compileKernels(options, program, folder.path());
  std::string table = kTableHead;
  fmt::print("{}", table);
  for (const RunCase& one : allCases(options)) {
    const std::string rows = rowsOf(one.name, takeTurns(programs, one, options, folder.path()));
    fmt::print("{}", rows);
    std::cout.flush();
    table += rows;
  }
  if (!options.document.empty()) {
    writeFileAtomically(options.document, withBlock(readFile(options.document), "run", table));
  }
}

}  // namespace

void addRunBenchmark(CLI::App& app) {
  const auto options = std::make_shared<RunBenchmark>();
  CLI::App* command = app.add_subcommand(
      "run", "Times whole runs of the program, from the scene file to the files it leaves.");
  command->add_option("--scenes", options->scenes, "scenes, or files that end in .toml")
      ->capture_default_str();
  command->add_option("--cup", options->cups, "cups with so many nodes on the long edge")
      ->check(CLI::Range(4, 20000))
      ->capture_default_str();
  command->add_option("--program", options->program, "the program [that of this build]")
      ->check(CLI::ExistingFile);
  command->add_option("--beside", options->beside, "another build of it, which takes turns")
      ->check(CLI::ExistingFile);
  command->add_option("--rounds", options->rounds, "of which the median counts")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--seconds", options->seconds, "after which a case begins no further round")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  command->add_option("--document", options->document,
                      "whose table between the marks `run` is written anew");
  command->callback([command, options] {  // Whoever names some of one kind wants no others.
    const bool hasScenes = command->count("--scenes") > 0;
    const bool hasCups = command->count("--cup") > 0;
    if (hasCups && !hasScenes) options->scenes.clear();
    if (hasScenes && !hasCups) options->cups.clear();
    run(*options);
  });
}

}  // namespace morphgrid
