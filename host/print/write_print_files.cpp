#include "print/write_print_files.h"

#include <fmt/format.h>

#include <fstream>
#include <memory>

#include "core/atomic_file.h"
#include "core/error.h"
#include "print/assembly_page.h"
#include "print/solid_files.h"

namespace morphgrid {
namespace {

constexpr const char* kThreeMfFile = "tiers.3mf";

std::filesystem::path tierFile(const std::filesystem::path& folder, int tier,
                               const char* extension) {
  return folder / fmt::format("tier_{}.{}", tier + 1, extension);
}

/// Files that become visible together.
class PendingFiles {
 public:
  void write(const std::filesystem::path& file, const std::string& text) {
    files_.push_back(std::make_unique<PendingFile>(file));
    std::ofstream stream(files_.back()->path(), std::ios::binary);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream || std::filesystem::is_directory(file)) {
      throw InputError(fmt::format(
          "{}: cannot be written: is the folder there, writable and not full?", file.string()));
    }
  }
  void commit() {
    for (const auto& file : files_) file->commit();
  }

 private:
  std::vector<std::unique_ptr<PendingFile>> files_;
};

constexpr const char* kForSlicers =
    "STL and 3MF are for looking, for posts and for uniform sheets: slicers lay every strut along "
    "itself, so that all would shrink alike";

void writeSolids(PendingFiles& files, const PrintPlan& plan, const std::filesystem::path& folder,
                 const PrintFileChoices& choices) {
  if (!choices.stl && !choices.threeMf) return;
  std::vector<SolidMesh> solids;
  for (int tier = 0; tier < plan.shape.layers; ++tier) solids.push_back(tierSolid(plan, tier));
  for (int tier = 0; choices.stl && tier < plan.shape.layers; ++tier) {
    files.write(tierFile(folder, tier, "stl"), stlOf(solids[tier]));
  }
  if (choices.threeMf) files.write(folder / kThreeMfFile, threeMfOf(solids));
}

/// Of an earlier print: tiers that there are no more, files that were not asked for.
void removeStale(const std::filesystem::path& folder, int tiers, const PrintFileChoices& choices) {
  const auto removeFrom = [&](int tier, const char* extension) {
    while (std::filesystem::remove(tierFile(folder, tier, extension))) ++tier;
  };
  removeFrom(tiers, "gcode");
  removeFrom(tiers, "svg");
  removeFrom(choices.stl ? tiers : 0, "stl");
  if (!choices.threeMf) std::filesystem::remove(folder / kThreeMfFile);
}

}  // namespace

void writePrintFiles(PrintRecord& record, const std::filesystem::path& folder,
                     const PrintFileChoices& choices) {
  PendingFiles files;
  const int tiers = record.plan.shape.layers;
  record.tiers.clear();
  for (int tier = 0; tier < tiers; ++tier) {
    const TierGcode gcode = writeTier(record.plan, tier, choices.isPlain);
    files.write(tierFile(folder, tier, "gcode"), gcode.text);
    files.write(tierFile(folder, tier, "svg"), tierMap(record.plan, tier));
    record.tiers.push_back(gcode.figures);
  }
  writeSolids(files, record.plan, folder, choices);
  if (choices.stl || choices.threeMf) record.notices.emplace_back(kForSlicers);
  files.write(folder / "print.json", printJson(record));
  files.write(folder / "assembly.html", assemblyPage(record));
  files.commit();
  removeStale(folder, tiers, choices);
}

}  // namespace morphgrid
