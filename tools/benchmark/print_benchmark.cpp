#include "benchmark/print_benchmark.h"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

#include "app/pipeline.h"
#include "benchmark/cost.h"
#include "benchmark/problem.h"
#include "benchmark/work_folder.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "core/read_file.h"
#include "print/write_print_files.h"
#include "report/generated_block.h"
#include "state/run_state.h"

namespace morphgrid {
namespace {

namespace fs = std::filesystem;

struct PrintBenchmark {
  std::vector<std::string> scenes{"strip", "egg_chair", "egg_chair_true"};
  fs::path printer = checkoutFolder() / "printers/prusa_mk4.toml";
  fs::path material = checkoutFolder() / "materials/pla_0.08.toml";
  int rounds = 5;
  std::string device;
  std::string document;
};

/// Of this process, in megabytes. field: "VmRSS", what it holds, or "VmHWM", the most it held since
/// forgetPeak().
double memoryOf(const std::string& field) {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    double kilobytes = 0;
    if (word == field + ":" && status >> kilobytes) return kilobytes / 1000;
  }
  return 0;
}

void forgetPeak() { std::ofstream("/proc/self/clear_refs") << 5; }

struct PrintCosts {
  PrintRecord record;
  double planned = 0, all = 0, cpu = 0;  ///< Medians, seconds.
  double memory = 0;                     ///< The most beyond what the design takes, megabytes.
  double bytes = 0;                      ///< Of G-code.
};

/// What `morphgrid print` does with a grid, but for simulating what is laid.
PrintCosts measurePrint(const std::string& name, const StrutGrid& grid,
                        const PrintBenchmark& options, const fs::path& folder) {
  const Printer printer = readPrinter(options.printer);
  const PrintMaterial material = readPrintMaterial(options.material);
  PrintCosts costs;
  std::vector<double> planned, all, cpu;
  for (int round = 0; round < options.rounds; ++round) {
    forgetPeak();
    const double before = memoryOf("VmRSS");
    Cost plan{};
    const Cost cost = costOf([&] {
      plan = costOf([&] { costs.record.plan = planPrint(name, grid, printer, material, {}); });
      writePrintFiles(costs.record, folder, {});
    });
    // Later rounds find memory that the first has left.
    if (round == 0) costs.memory = memoryOf("VmHWM") - before;
    planned.push_back(plan.wall);
    all.push_back(cost.wall);
    cpu.push_back(cost.cpu);
  }
  costs.planned = median(planned);
  costs.all = median(all);
  costs.cpu = median(cpu);
  for (int tier = 1; tier <= grid.shape.layers; ++tier) {
    costs.bytes += static_cast<double>(fs::file_size(folder / fmt::format("tier_{}.gcode", tier)));
  }
  return costs;
}

std::string printRow(const PrintCosts& costs) {
  double path = 0;
  for (const TierFigures& tier : costs.record.tiers) path += tier.laidMm() / 1000;
  return fmt::format("| {} | {} | {:.0f} | {:.0f} | {:.2f} | {:.2f} | {:.2f} | {:.0f} |\n",
                     costs.record.plan.name, costs.record.plan.figures.struts, path,
                     costs.bytes / 1e6, costs.planned, costs.all, costs.cpu, costs.memory);
}

StrutGrid designedGrid(const std::string& nameOrFile, const PrintBenchmark& options,
                       const fs::path& folder) {
  Scene scene = loadScene(sceneFile(nameOrFile));
  scene.pictures.enabled = false;
  scene.files = {.gltf = false, .vtu = false, .ply = false, .obj = false, .state = true};
  const RunRecord record =
      runScene(scene, {folder, {.selection = options.device, .validation = false}, true, {}, {}});
  if (record.deviceFailure) throw DeviceError(*record.deviceFailure);
  return readState(folder / kStateFile).grid;
}

void runPrints(const PrintBenchmark& options) {
  if (!options.document.empty()) {  // Better now than when all is done.
    withBlock(readFile(options.document), "print", "");
  }
  std::string table =
      "| | struts | path, m | G-code, MB | plan, s | plan and files, s | CPU, s | memory, MB |\n"
      "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
  fmt::print("{}", table);
  const WorkFolder folder;
  for (const std::string& name : options.scenes) {
    const StrutGrid grid = designedGrid(name, options, folder.path());
    const std::string row =
        printRow(measurePrint(fs::path(name).stem(), grid, options, folder.path()));
    fmt::print("{}", row);
    std::cout.flush();
    table += row;
  }
  if (!options.document.empty()) {
    writeFileAtomically(options.document, withBlock(readFile(options.document), "print", table));
  }
}

}  // namespace

void addPrintBenchmark(CLI::App& app) {
  const auto options = std::make_shared<PrintBenchmark>();
  CLI::App* print = app.add_subcommand("print", "Times plan and G-code of designed scenes.");
  print->add_option("--scenes", options->scenes, "scenes, or files that end in .toml")
      ->capture_default_str();
  print->add_option("--printer", options->printer, "a printer file")->capture_default_str();
  print->add_option("--material", options->material, "a material file")->capture_default_str();
  print->add_option("--rounds", options->rounds, "of which the median counts")
      ->check(CLI::PositiveNumber)
      ->capture_default_str();
  print->add_option("--document", options->document,
                    "whose table between the marks `print` is written anew");
  print->add_option("--device", options->device, "index or part of the name of a Vulkan device");
  print->callback([options] { runPrints(*options); });
}

}  // namespace morphgrid
