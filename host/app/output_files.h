#pragma once
#include <chrono>
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "app/progress_line.h"

namespace morphgrid {

/// The files that a command leaves in a folder. One that cannot be written does not keep the others
/// from it.
class OutputFiles {
 public:
  OutputFiles(std::filesystem::path folder, bool quiet);

  const std::filesystem::path& folder() const { return folder_; }

  /// name: in the folder. write: throws OutputError when the disk refuses, std::bad_alloc when
  /// memory does.
  void write(const std::string& name,
             const std::function<void(const std::filesystem::path&)>& write);
  /// The same of a file anywhere.
  void writeAt(const std::filesystem::path& file,
               const std::function<void(const std::filesystem::path&)>& write);

  /// In the order of writing.
  const std::vector<std::filesystem::path>& written() const { return written_; }
  /// What could not be written and why, a line each, beginning with the file's name.
  const std::vector<std::string>& lost() const { return lost_; }

 private:
  void tell(const std::filesystem::path& file);

  std::filesystem::path folder_;
  bool quiet_;
  ProgressLine line_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::vector<std::filesystem::path> written_;
  std::vector<std::string> lost_;
};

}  // namespace morphgrid
