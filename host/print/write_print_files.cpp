#include "print/write_print_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "print/assembly_page.h"
#include "print/pending_files.h"
#include "print/solid_files.h"

namespace morphgrid {
namespace {

constexpr const char* kThreeMfFile = "tiers.3mf";

std::filesystem::path tierFile(const std::filesystem::path& folder, int tier,
                               const char* extension) {
  return folder / fmt::format("tier_{}.{}", tier + 1, extension);
}

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
