#include "print/write_print_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>
#include <memory>

#include "core/atomic_file.h"
#include "core/output_error.h"
#include "print/assembly_page.h"

namespace morphgrid {
namespace {

std::filesystem::path tierFile(const std::filesystem::path& folder, int tier,
                               const char* extension) {
  return folder / fmt::format("tier_{}.{}", tier + 1, extension);
}

/// Files that become visible together: tiers of two prints do not fit.
class PendingFiles {
 public:
  void write(const std::filesystem::path& file, const std::string& text) {
    files_.push_back(std::make_unique<PendingFile>(file));
    std::ofstream stream(files_.back()->path(), std::ios::binary);
    stream.write(text.data(), static_cast<std::streamsize>(text.size()));
    stream.close();
    if (!stream || std::filesystem::is_directory(file)) {
      lost_.push_back(fmt::format(
          "{}: cannot be written: is the folder there, writable and not full?", file.string()));
    }
  }
  /// Throws OutputError with each of those that cannot be, and then none is there.
  void commit() {
    if (!lost_.empty()) {
      throw OutputError(
          fmt::format("{}\nno file of the print was written: each belongs to the others",
                      fmt::join(lost_, "\n")));
    }
    for (const auto& file : files_) file->commit();
  }

 private:
  std::vector<std::unique_ptr<PendingFile>> files_;
  std::vector<std::string> lost_;
};

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
