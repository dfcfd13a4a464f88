#include "print/write_print_files.h"

#include <fmt/format.h>

#include <fstream>
#include <memory>

#include "core/atomic_file.h"
#include "core/error.h"

namespace morphgrid {
namespace {

std::filesystem::path tierFile(const std::filesystem::path& folder, int tier) {
  return folder / fmt::format("tier_{}.gcode", tier + 1);
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

}  // namespace

void writePrintFiles(PrintRecord& record, const std::filesystem::path& folder, bool isPlain) {
  PendingFiles files;
  const int tiers = record.plan.shape.layers;
  record.tiers.clear();
  for (int tier = 0; tier < tiers; ++tier) {
    const TierGcode gcode = writeTier(record.plan, tier, isPlain);
    files.write(tierFile(folder, tier), gcode.text);
    record.tiers.push_back(gcode.figures);
  }
  files.write(folder / "print.json", printJson(record));
  files.commit();
  for (int tier = tiers; std::filesystem::exists(tierFile(folder, tier)); ++tier) {
    std::filesystem::remove(tierFile(folder, tier));
  }
}

}  // namespace morphgrid
