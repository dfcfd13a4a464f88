#pragma once
#include <filesystem>
#include <functional>
#include <ostream>
#include <string_view>

namespace morphgrid {

/// A file under construction: write to path(), then commit() renames it to its final name.
/// Without commit() nothing is left behind and a file already there stays as it was, even when
/// Ctrl-C ends the program meanwhile. What killed processes of this machine left of the same file
/// is removed.
class PendingFile {
 public:
  explicit PendingFile(std::filesystem::path finalPath);
  ~PendingFile();
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;

  /// The temporary name, in the same folder and with the same extension as the final one.
  const std::filesystem::path& path() const { return temporaryPath_; }

  /// Throws OutputError when the file cannot be renamed.
  void commit();

 private:
  std::filesystem::path finalPath_;
  std::filesystem::path temporaryPath_;
  bool committed_ = false;
  int slot_;  ///< See removeWhenEnded().
};

/// Writes to a temporary name and renames. Throws OutputError when the disk refuses.
void writeFileAtomically(const std::filesystem::path& path,
                         const std::function<void(std::ostream&)>& write);
void writeFileAtomically(const std::filesystem::path& path, std::string_view bytes);

}  // namespace morphgrid
