#include "core/file_watch.h"

#include <algorithm>

namespace morphgrid {
namespace {

std::optional<std::filesystem::file_time_type> timeOf(const std::filesystem::path& file) {
  std::error_code error;
  const auto time = std::filesystem::last_write_time(file, error);
  return error ? std::nullopt : std::optional(time);
}

}  // namespace

FileWatch::FileWatch(const std::vector<std::filesystem::path>& files) {
  for (const auto& file : files) {
    seen_.push_back({file, timeOf(file)});
  }
}

bool FileWatch::hasChanged() const {
  return std::any_of(seen_.begin(), seen_.end(),
                     [](const Seen& seen) { return timeOf(seen.file) != seen.time; });
}

}  // namespace morphgrid
