#include "print/write_print_files.h"

#include <fmt/format.h>

#include "print/assembly_page.h"
#include "print/pending_files.h"

namespace morphgrid {
namespace {

std::filesystem::path tierFile(const std::filesystem::path& folder, int tier,
                               const char* extension) {
  return folder / fmt::format("tier_{}.{}", tier + 1, extension);
}

}  // namespace

void writePrintFiles(PrintRecord& record, const std::filesystem::path& folder, bool isPlain) {
  PendingFiles files;
  const int tiers = record.plan.shape.layers;
  record.tiers.clear();
  for (int tier = 0; tier < tiers; ++tier) {
    const TierGcode gcode = writeTier(record.plan, tier, isPlain);
    files.write(tierFile(folder, tier, "gcode"), gcode.text);
    files.write(tierFile(folder, tier, "svg"), tierMap(record.plan, tier));
    record.tiers.push_back(gcode.figures);
  }
  files.write(folder / "print.json", printJson(record));
  files.write(folder / "assembly.html", assemblyPage(record));
  files.commit();
  for (int tier = tiers; std::filesystem::remove(tierFile(folder, tier, "gcode")); ++tier) {
    std::filesystem::remove(tierFile(folder, tier, "svg"));
  }
}

}  // namespace morphgrid
