#include "benchmark/disturbed_runs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <nlohmann/json.hpp>

#include "core/atomic_file.h"
#include "core/error.h"
#include "core/on_interrupt.h"
#include "core/read_file.h"
#include "report/generated_block.h"
#include "state/run_state.h"

namespace morphgrid {
namespace {

constexpr const char* kRunsBlock = "disturbed runs";
constexpr const char* kRunsHead =
    "## Disturbed runs\n\nWritten by `tools/robustness runs --document docs/robustness.md`.\n\n";

bool isWhole(const std::filesystem::path& file) {
  const std::string bytes = readFile(file);
  const std::string kind = file.extension();
  if (kind == ".json") return nlohmann::json::accept(bytes);
  if (kind == ".png") return bytes.find("IEND") != bytes.npos;
  if (kind == ".vtu") return bytes.find("</VTKFile>") != bytes.npos;
  if (kind == ".svg") return bytes.find("</svg>") != bytes.npos;
  if (kind == ".csv" || kind == ".obj") return bytes.ends_with('\n');
  if (kind == ".glb") {
    std::uint32_t size = 0;
    if (bytes.size() < 12) return false;
    std::memcpy(&size, bytes.data() + 8, sizeof(size));
    return size == bytes.size();
  }
  if (kind == ".safetensors") {
    try {
      readState(file);
    } catch (const InputError&) {
      return false;
    }
  }
  return !bytes.empty();
}

struct DisturbedOptions {
  DisturbedPlace place{
      .program = std::filesystem::read_symlink("/proc/self/exe").parent_path() / "../morphgrid",
      .scenes = "scenes",
      .folder = std::filesystem::temp_directory_path() / "morphgrid_disturbed"};
  std::string only;
  std::filesystem::path document;
};

void run(const DisturbedOptions& options) {
  using Group = std::string (*)(const DisturbedPlace&, bool&);
  const std::pair<const char*, Group> groups[] = {
      {"kill", killAndResume}, {"disk", fillDisks}, {"interrupt", interruptPhases}};
  installInterruptHandler();
  const OnInterrupt ending(InterruptAct::end, "");
  DisturbedPlace place = options.place;
  place.folder = emptyFolder(place.folder);
  std::string text;
  bool isWell = true;
  for (const auto& [name, group] : groups) {
    if (std::string(name).find(options.only) == std::string::npos) continue;
    const std::string table = group(place, isWell);
    fmt::print("{}\n", table);
    std::fflush(stdout);
    text += table + "\n";
  }
  std::filesystem::remove_all(place.folder);
  if (text.empty())
    throw InputError(fmt::format("--only {}: there is no such group", options.only));
  if (!options.document.empty()) {
    writeFileAtomically(options.document,
                        withBlock(readFile(options.document), kRunsBlock, kRunsHead + text));
  }
  if (!isWell) throw std::runtime_error("a run did not end as it should");
}

}  // namespace

std::filesystem::path emptyFolder(const std::filesystem::path& folder) {
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  return folder;
}

std::vector<std::string> listHalfFiles(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  if (!std::filesystem::exists(folder)) return names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    const std::string name = entry.path().filename();
    if (name.front() != '.' && !isWhole(entry.path())) names.push_back(name);
  }
  return names;
}

int countTemporaries(const std::filesystem::path& folder) {
  if (!std::filesystem::exists(folder)) return 0;
  return static_cast<int>(std::count_if(
      std::filesystem::directory_iterator(folder), {},
      [](const auto& entry) { return entry.path().filename().string().front() == '.'; }));
}

void addDisturbedRuns(CLI::App& app) {
  const auto options = std::make_shared<DisturbedOptions>();
  CLI::App* disturb = app.add_subcommand(
      "disturb", "Kills, interrupts and starves runs of the program and tells how each one ended.");
  disturb->add_option("--scenes", options->place.scenes, "folder of the scene files")
      ->capture_default_str();
  disturb->add_option("--program", options->place.program, "the program [that of this build]");
  disturb->add_option("--folder", options->place.folder, "emptied, used and removed")
      ->capture_default_str();
  disturb->add_option("--only", options->only, "one group: kill, disk or interrupt");
  disturb->add_option("--document", options->document, "also put the tables into this document");
  disturb->callback([options] { run(*options); });
}

}  // namespace morphgrid
