#pragma once
#include <filesystem>
#include <functional>
#include <future>
#include <string>
#include <vector>

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
  /// As write(), while the caller goes on, one file at a time. write: owns what it writes; what it
  /// throws beside the above is thrown by the next call.
  void writeMeanwhile(const std::string& name,
                      std::function<void(const std::filesystem::path&)> write);
  /// Waits for the last of these: to be called before written() and lost().
  void finish();

  /// In the order of writing.
  const std::vector<std::filesystem::path>& written() const { return written_; }
  /// What could not be written and why, a line each, beginning with the file's name.
  const std::vector<std::string>& lost() const { return lost_; }

 private:
  void writeNow(const std::filesystem::path& file,
                const std::function<void(const std::filesystem::path&)>& write);

  std::filesystem::path folder_;
  bool quiet_;
  std::vector<std::filesystem::path> written_;
  std::vector<std::string> lost_;
  std::future<void> meanwhile_;  ///< Last: it uses all of the above.
};

}  // namespace morphgrid
