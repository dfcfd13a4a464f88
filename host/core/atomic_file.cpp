#include "core/atomic_file.h"

#include <fmt/format.h>
#include <unistd.h>

#include <fstream>

#include "core/error.h"

namespace morphgrid {

PendingFile::PendingFile(std::filesystem::path finalPath) : finalPath_(std::move(finalPath)) {
  temporaryPath_ =
      finalPath_.parent_path() / fmt::format(".{}.{}{}", finalPath_.stem().string(), getpid(),
                                             finalPath_.extension().string());
}

PendingFile::~PendingFile() {
  if (!committed_) {
    std::error_code ignored;  // A destructor has nobody to tell; the file may never have been made.
    std::filesystem::remove(temporaryPath_, ignored);
  }
}

void PendingFile::commit() {
  std::error_code error;
  std::filesystem::rename(temporaryPath_, finalPath_, error);
  if (error) {
    throw InputError(
        fmt::format("{}: cannot be written: {}", finalPath_.string(), error.message()));
  }
  committed_ = true;
}

void writeFileAtomically(const std::filesystem::path& path,
                         const std::function<void(std::ostream&)>& write) {
  PendingFile pending(path);
  std::ofstream stream(pending.path(), std::ios::binary);
  write(stream);
  stream.close();
  if (!stream) {
    throw InputError(fmt::format(
        "{}: cannot be written: is the folder there, writable and not full?", path.string()));
  }
  pending.commit();
}

void writeFileAtomically(const std::filesystem::path& path, std::string_view bytes) {
  writeFileAtomically(path, [&](std::ostream& stream) {
    stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  });
}

}  // namespace morphgrid
