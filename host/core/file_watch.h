#pragma once
#include <filesystem>
#include <optional>
#include <vector>

namespace morphgrid {

/// Tells whether files have changed on disk.
class FileWatch {
 public:
  /// Watches nothing.
  FileWatch() = default;
  /// Watches for changes of these files from now on; one that is not there may come to be.
  explicit FileWatch(const std::vector<std::filesystem::path>& files);

  bool hasChanged() const;

 private:
  struct Seen {
    std::filesystem::path file;
    std::optional<std::filesystem::file_time_type> time;  ///< None: not there.
  };

  std::vector<Seen> seen_;
};

}  // namespace morphgrid
