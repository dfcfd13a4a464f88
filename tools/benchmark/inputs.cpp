#include "benchmark/inputs.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>
#include <sstream>
#include <string>
#include <vector>

#include "app/pipeline.h"
#include "app/propose_files.h"
#include "core/atomic_file.h"
#include "core/error.h"
#include "core/interrupt.h"
#include "core/read_file.h"
#include "report/generated_block.h"

namespace morphgrid {
namespace {

struct InputsOptions {
  std::filesystem::path table;
  std::filesystem::path meshes;
  std::vector<std::filesystem::path> single;
  std::string document;
  std::string device;
};

struct Input {
  std::filesystem::path mesh;
  std::string origin;  ///< Package and licence, for people.
};

/// A mesh, and what came of it.
struct DesignedInput {
  Input input;
  std::optional<SceneProposal> proposal;
  std::optional<RunRecord> record;
  double proposedIn = 0;  ///< s
  double seconds = 0;     ///< In all.
  std::string failure;    ///< Why one of them is not there.
};

using Clock = std::chrono::steady_clock;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Lines of file, checksum, package, file of the package, licence.
std::vector<Input> readTable(const InputsOptions& options) {
  std::vector<Input> inputs;
  std::istringstream lines(readFile(options.table));
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string name, sum, package, file, licence;
    if (line.starts_with('#') || !(words >> name >> sum >> package >> file)) {
      continue;
    }
    std::getline(words >> std::ws, licence);
    inputs.push_back({options.meshes / name, fmt::format("{}, {}", package, licence)});
  }
  return inputs;
}

DesignedInput design(const Input& input, const std::filesystem::path& folder,
                     const DeviceOptions& device) {
  DesignedInput result{.input = input};
  const Clock::time_point start = Clock::now();
  try {
    ProposedFiles files = proposeFiles({.mesh = input.mesh}, folder, true);
    result.proposedIn = secondsSince(start);
    result.proposal = std::move(files.proposal);
    result.record = runScene(loadScene(files.scene), {folder, device, true, {}, {}});
  } catch (const InputError& error) {
    const std::string message = error.what();
    result.failure = message.substr(0, message.find('\n'));
  }
  result.seconds = secondsSince(start);
  return result;
}

std::string outcomeOf(const RunRecord& record) {
  const TargetDistance& distance = record.distance.value();
  const ShrinkFigures& shrink = record.shrink.value();
  return fmt::format("**{:.3f}** / {:.2f} | {:.1f} | {} / {}", distance.rmsPercent,
                     distance.maxPercent, shrink.largestPercent, shrink.strutsOverLimit,
                     shrink.strutsGrowing);
}

std::string rowOf(const DesignedInput& one) {
  std::string row =
      fmt::format("| {} | {} | ", one.input.mesh.filename().string(), one.input.origin);
  if (one.proposal) {
    const SceneProposal& proposal = *one.proposal;
    const SamplingBox& box = *proposal.surface.box;
    row += fmt::format("{} | {:.3g} x {:.3g} | {:.0f} | {} | ", proposal.placement.sight.name,
                       box.uLength, box.vLength, 100 * proposal.share, nameOf(proposal.design.net));
  } else {
    row += "| | | | ";
  }
  if (one.record) {
    row += fmt::format("{} x {} | {} | ", one.record->grid.shape.verticesU,
                       one.record->grid.shape.verticesV, outcomeOf(*one.record));
  } else {
    row += fmt::format("{} | | | | ", one.failure);
  }
  return row + fmt::format("{:.1f} | {:.1f} |\n", one.proposedIn, one.seconds);
}

std::string medianLine(const std::vector<DesignedInput>& all) {
  std::vector<double> distances;
  for (const DesignedInput& one : all) {
    if (one.record && one.record->distance) {
      distances.push_back(one.record->distance->rmsPercent);
    }
  }
  if (distances.empty()) return "";
  std::sort(distances.begin(), distances.end());
  const std::size_t half = distances.size() / 2;
  const double median =
      distances.size() % 2 == 1 ? distances[half] : (distances[half - 1] + distances[half]) / 2;
  return fmt::format("\nDesigned: {} of {}. RMS: median {:.3f} %, largest {:.3f} %.\n",
                     distances.size(), all.size(), median, distances.back());
}

constexpr const char* kHeader =
    "| mesh | from | rays look | box, mm | share, % | net | nodes | RMS / max, % | largest shrink, "
    "% | over / growing | proposed, s | in all, s |\n"
    "| --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";

void run(const InputsOptions& options) {
  const DeviceOptions deviceOptions{.selection = options.device, .validation = false};
  const Device device(deviceOptions);
  if (!options.document.empty()) {  // Better now than after half an hour.
    withBlock(readFile(options.document), "inputs", "");
  }
  std::vector<Input> inputs = options.table.empty() ? std::vector<Input>{} : readTable(options);
  for (const std::filesystem::path& mesh : options.single) {
    inputs.push_back({mesh, ""});
  }
  fmt::print("device: {}\n{}", device.name(), kHeader);
  std::string table = kHeader;
  std::vector<DesignedInput> all;
  for (const Input& input : inputs) {
    const auto folder = std::filesystem::path("out") / "inputs" / input.mesh.stem();
    all.push_back(design(input, folder, deviceOptions));
    if (interruptRequested()) return;
    const std::string row = rowOf(all.back());
    fmt::print("{}", row);
    std::cout.flush();
    table += row;
  }
  const std::string median = medianLine(all);
  fmt::print("{}", median);
  if (!options.document.empty()) {
    const std::string document = withBlock(readFile(options.document), "device",
                                           fmt::format("Measured on {}.\n", device.name()));
    writeFileAtomically(options.document, withBlock(document, "inputs", table + median));
  }
}

}  // namespace

void addInputsTable(CLI::App& app) {
  const auto options = std::make_shared<InputsOptions>();
  CLI::App* inputs =
      app.add_subcommand("inputs", "Designs meshes with nothing else said (see tools/inputs).");
  inputs->add_option("--table", options->table, "lists the meshes: tools/inputs.txt");
  inputs->add_option("--meshes", options->meshes, "the folder that holds them");
  inputs->add_option("--mesh", options->single, "meshes, instead or too");
  inputs->add_option("--document", options->document,
                     "whose table between the marks `inputs` is written anew");
  inputs->add_option("--device", options->device, "index or part of the name of a Vulkan device");
  inputs->callback([options] { run(*options); });
}

}  // namespace morphgrid
