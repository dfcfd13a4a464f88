#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/atomic_file.h"

namespace morphgrid {

/// Files that become visible together.
class PendingFiles {
 public:
  /// Throws InputError when it cannot be written.
  void write(const std::filesystem::path& file, const std::string& text);
  void commit();

 private:
  std::vector<std::unique_ptr<PendingFile>> files_;
};

}  // namespace morphgrid
