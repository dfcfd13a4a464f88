#include "core/atomic_file.h"

#include <fmt/format.h>
#include <signal.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <fstream>
#include <optional>

#include "core/on_interrupt.h"
#include "core/output_error.h"

namespace morphgrid {

namespace {

std::filesystem::path temporaryOf(const std::filesystem::path& finalPath, pid_t process) {
  return finalPath.parent_path() / fmt::format(".{}.{}{}", finalPath.stem().string(), process,
                                               finalPath.extension().string());
}

/// The process that a temporary name holds; nothing of another name.
std::optional<pid_t> writerOf(const std::filesystem::path& file,
                              const std::filesystem::path& finalPath) {
  const std::string name = file.filename().string();
  const std::size_t start = finalPath.stem().string().size() + 2;  // Behind two dots.
  pid_t process = 0;
  if (name.size() <= start) return std::nullopt;
  const char* end = name.data() + name.size();
  const bool isNumber =
      std::from_chars(name.data() + start, end, process).ec == std::errc() && process > 0;
  const bool isSame = isNumber && temporaryOf(finalPath, process).filename() == file.filename();
  return isSame ? std::optional(process) : std::nullopt;
}

bool isAlive(pid_t process) { return kill(process, 0) == 0 || errno != ESRCH; }

/// What runs that were killed have left of this file. Errors are ignored: the file itself can be
/// written all the same, or writing it tells why not.
void removeStale(const std::filesystem::path& finalPath) {
  namespace fs = std::filesystem;
  const fs::path parent = finalPath.parent_path();
  std::error_code error;
  for (fs::directory_iterator entry(parent.empty() ? fs::path(".") : parent, error);
       !error && entry != fs::directory_iterator(); entry.increment(error)) {
    std::error_code ignored;
    const auto writer = writerOf(entry->path(), finalPath);
    if (writer && !isAlive(*writer) && fs::is_regular_file(entry->symlink_status(ignored))) {
      fs::remove(entry->path(), ignored);
    }
  }
}

}  // namespace

PendingFile::PendingFile(std::filesystem::path finalPath) : finalPath_(std::move(finalPath)) {
  temporaryPath_ = temporaryOf(finalPath_, getpid());
  removeStale(finalPath_);
  slot_ = removeWhenEnded(temporaryPath_.c_str());
}

PendingFile::~PendingFile() {
  keepWhenEnded(slot_);
  if (!committed_) {
    std::error_code ignored;  // A destructor has nobody to tell; the file may never have been made.
    std::filesystem::remove(temporaryPath_, ignored);
  }
}

void PendingFile::commit() {
  std::error_code error;
  std::filesystem::rename(temporaryPath_, finalPath_, error);
  if (error) {
    throw OutputError(
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
    throw OutputError(fmt::format(
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
