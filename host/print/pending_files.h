#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/atomic_file.h"

namespace morphgrid {

/// Files that become visible together: those of two prints do not fit.
class PendingFiles {
 public:
  void write(const std::filesystem::path& file, const std::string& text);
  /// Throws OutputError with each of those that cannot be written, and then none is there.
  void commit();

 private:
  std::vector<std::unique_ptr<PendingFile>> files_;
  std::vector<std::string> lost_;
};

}  // namespace morphgrid
