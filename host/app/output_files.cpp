#include "app/output_files.h"

#include <fmt/format.h>

#include <new>

#include "core/output_error.h"

namespace morphgrid {

OutputFiles::OutputFiles(std::filesystem::path folder, bool quiet)
    : folder_(std::move(folder)), quiet_(quiet), line_("files", 0) {}

void OutputFiles::write(const std::string& name,
                        const std::function<void(const std::filesystem::path&)>& write) {
  writeAt(folder_ / name, write);
}

void OutputFiles::writeAt(const std::filesystem::path& file,
                          const std::function<void(const std::filesystem::path&)>& write) {
  finish();
  writeNow(file, write);
}

void OutputFiles::writeMeanwhile(const std::string& name,
                                 std::function<void(const std::filesystem::path&)> write) {
  finish();
  meanwhile_ = std::async(
      std::launch::async,
      [this, file = folder_ / name, write = std::move(write)] { writeNow(file, write); });
}

void OutputFiles::finish() {
  if (meanwhile_.valid()) meanwhile_.get();
}

void OutputFiles::writeNow(const std::filesystem::path& file,
                           const std::function<void(const std::filesystem::path&)>& write) {
  tell(file);
  try {
    write(file);
    written_.push_back(file);
  } catch (const OutputError& error) {
    lost_.emplace_back(error.what());
  } catch (const std::filesystem::filesystem_error& error) {
    lost_.push_back(fmt::format("{}: {}", file.string(), error.what()));
  } catch (const std::bad_alloc&) {
    lost_.push_back(fmt::format("{}: cannot be written: out of memory", file.string()));
  }
}

void OutputFiles::tell(const std::filesystem::path& file) {
  if (quiet_) return;
  const bool isFirst = written_.empty() && lost_.empty();
  if (isFirst) start_ = std::chrono::steady_clock::now();  // What came before was no writing.
  const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start_;
  line_.tell(fmt::format("{} written, now {}", written_.size(), file.filename().string()),
             seconds.count(), -1);
}

}  // namespace morphgrid
