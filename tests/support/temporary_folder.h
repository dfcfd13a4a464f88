#pragma once
#include <filesystem>
#include <string>
#include <string_view>

namespace morphgrid {

/// A new, empty folder that is removed with everything in it.
class TemporaryFolder {
 public:
  TemporaryFolder();
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }
  int fileCount() const;

  /// Writes a file, making folders on the way, and returns its path.
  std::filesystem::path write(const std::filesystem::path& name, std::string_view text) const;

  /// The text with the folder's path and the slash behind it taken out.
  std::string withoutPath(std::string text) const;

 private:
  std::filesystem::path path_;
};

}  // namespace morphgrid
