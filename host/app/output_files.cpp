#include "app/output_files.h"

#include <fmt/format.h>

#include <new>

#include "app/activity_line.h"
#include "core/output_error.h"

namespace morphgrid {

OutputFiles::OutputFiles(std::filesystem::path folder, bool quiet)
    : folder_(std::move(folder)), quiet_(quiet) {}

void OutputFiles::write(const std::string& name,
                        const std::function<void(const std::filesystem::path&)>& write) {
  writeAt(folder_ / name, write);
}

void OutputFiles::writeAt(const std::filesystem::path& file,
                          const std::function<void(const std::filesystem::path&)>& write) {
  finish();
  const ActivityLine writing(fmt::format("writing {}", file.filename().string()), quiet_);
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

}  // namespace morphgrid
