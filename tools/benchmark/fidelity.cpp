#include "benchmark/fidelity.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iostream>

#include "benchmark/fidelity_cases.h"
#include "benchmark/fidelity_picture.h"
#include "benchmark/fidelity_tables.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "core/interrupt.h"
#include "core/read_file.h"
#include "render/picture.h"
#include "report/generated_block.h"

namespace morphgrid {
namespace {

constexpr int kQuickSteps = 8;

struct FidelityOptions {
  std::vector<std::string> names;
  std::filesystem::path scenes = "scenes";
  std::filesystem::path document = "docs/fidelity.md";
  std::filesystem::path folder = "out/compare";
  std::string selection;
  bool quick = false;

  /// Only then the figures replace those of the documents.
  bool complete() const { return names.empty() && !quick; }
};

std::vector<FidelityCase> chosenCases(const FidelityOptions& options) {
  const std::vector<FidelityCase> all = listFidelityCases(options.scenes);
  if (options.names.empty()) {
    return all;
  }
  std::vector<FidelityCase> chosen;
  for (const std::string& name : options.names) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const FidelityCase& one) { return one.name == name; });
    if (found == all.end()) {
      std::vector<std::string> known;
      for (const FidelityCase& one : all) known.push_back(one.name);
      throw InputError(fmt::format("there is no {}; there are {}", name, fmt::join(known, ", ")));
    }
    chosen.push_back(*found);
  }
  return chosen;
}

FidelityRun runAndTell(const Scene& scene, const MaterialRequest& bars,
                       const FidelityOptions& options) {
  fmt::print("{:<16} ", scene.name);
  std::cout.flush();
  FidelityRun run = runForFidelity(scene, options.folder / scene.name,
                                   {.selection = options.selection, .validation = false}, bars);
  fmt::print("{}\n", describe(run));
  if (interruptRequested()) {
    throw std::runtime_error("interrupted");
  }
  return run;
}

FidelityTrio compare(const FidelityCase& one, const FidelityOptions& options) {
  Scene springs = one.springs();
  Scene ours = one.ours();
  if (options.quick) {
    for (Scene* scene : {&springs, &ours}) {
      scene->design.optimiseSteps = std::min(scene->design.optimiseSteps, kQuickSteps);
    }
  }
  const MaterialRequest& bars = ours.material;
  FidelityRun papers = runAndTell(one.papers(), bars, options);
  FidelityRun inSprings = runAndTell(springs, bars, options);
  return {one.name, one.random, std::move(papers), std::move(inSprings),
          runAndTell(ours, bars, options)};
}

std::filesystem::path pictureOf(const FidelityTrio& trio) {
  return fmt::format("fidelity_{}.png", trio.name);
}

std::vector<FidelityTrio> select(const std::vector<FidelityTrio>& trios, bool random) {
  std::vector<FidelityTrio> selected;
  std::copy_if(trios.begin(), trios.end(), std::back_inserter(selected),
               [&](const FidelityTrio& trio) { return trio.random == random; });
  return selected;
}

std::string withTables(std::string document, const std::vector<FidelityTrio>& trios) {
  const auto scenes = select(trios, false);
  const auto random = select(trios, true);
  document = withBlock(document, "device",
                       fmt::format("Measured on {}.\n", trios.front().ours.record.device));
  document = withBlock(document, "scenes", scenes.empty() ? "" : sceneTable(scenes));
  return withBlock(document, "random patches", random.empty() ? "" : randomTable(random));
}

void run(const FidelityOptions& options) {
  installInterruptHandler();
  const Device device({.selection = options.selection, .validation = false});
  const std::string document = readFile(options.document);
  std::vector<FidelityTrio> trios;
  for (const FidelityCase& one : chosenCases(options)) {
    trios.push_back(compare(one, options));
    writePng(options.folder / pictureOf(trios.back()), drawFidelity(device, trios.back()));
  }
  const auto result =
      options.complete() ? options.document : options.folder / options.document.filename();
  writeFileAtomically(result, withTables(document, trios));
  if (options.complete()) {
    for (const FidelityTrio& trio : select(trios, false)) {
      writeFileAtomically(options.document.parent_path() / "images" / pictureOf(trio),
                          readFile(options.folder / pictureOf(trio)));
    }
  }
  fmt::print("tables in {}, runs and pictures in {}\n", result.string(), options.folder.string());
}

}  // namespace

void addFidelityTable(CLI::App& app) {
  const auto options = std::make_shared<FidelityOptions>();
  CLI::App* command = app.add_subcommand(
      "fidelity",
      "Sets the paper's design beside those for the shape: how close they come, as frames.");
  command->add_option("NAME", options->names, "only these: patch, face, random_3, ...");
  command->add_option("--scenes", options->scenes, "folder of the scene files")
      ->capture_default_str();
  command->add_option("--document", options->document, "whose tables are written anew")
      ->capture_default_str();
  command->add_option("--out", options->folder, "folder of the runs")->capture_default_str();
  command->add_option("--device", options->selection,
                      "index or part of the name of a Vulkan device");
  command->add_flag("--quick", options->quick, "a few steps of optimisation only");
  command->callback([options] { run(*options); });
}

}  // namespace morphgrid
