#include "print/pending_files.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <fstream>
#include <system_error>

#include "core/output_error.h"

namespace morphgrid {

void PendingFiles::write(const std::filesystem::path& file, const std::string& text) {
  files_.push_back(std::make_unique<PendingFile>(file));
  std::ofstream stream(files_.back()->path(), std::ios::binary);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.close();
  if (std::filesystem::is_directory(file)) {
    lost_.push_back(fmt::format("{}: cannot be written: {}", file.string(),
                                std::make_error_code(std::errc::is_a_directory).message()));
  } else if (!stream) {
    lost_.push_back(fmt::format(
        "{}: cannot be written: is the folder there, writable and not full?", file.string()));
  }
}

void PendingFiles::commit() {
  if (!lost_.empty()) {
    throw OutputError(
        fmt::format("{}\nno file was written: each belongs to the others", fmt::join(lost_, "\n")));
  }
  for (const auto& file : files_) file->commit();
}

}  // namespace morphgrid
