// Runs into disks that are full at each of the files that a run writes.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/mount.h>

#include <algorithm>

#include "benchmark/child_process.h"
#include "benchmark/disturbed_runs.h"
#include "core/error.h"

namespace morphgrid {
namespace {

constexpr std::uintmax_t kPage = 4096;  // What small disks are made of.

struct WrittenFile {
  std::string name;
  std::uintmax_t pages;
  std::filesystem::file_time_type time;
};

std::vector<std::string> runInto(const DisturbedPlace& place, const std::filesystem::path& out) {
  return {"run",   place.scene("egg_chair_true"),
          "--out", out,
          "--set", "grid.nodes_long=14",
          "--set", "design.compensate=2",
          "--set", "output.width=640",
          "--set", "output.height=480"};
}

/// In the order in which they were written.
std::vector<WrittenFile> listWritten(const std::filesystem::path& out) {
  std::vector<WrittenFile> files;
  for (const auto& entry : std::filesystem::directory_iterator(out)) {
    files.push_back({entry.path().filename(), (entry.file_size() + kPage - 1) / kPage,
                     entry.last_write_time()});
  }
  std::ranges::sort(files, {}, &WrittenFile::time);
  return files;
}

/// A disk in memory, while it lives.
class SmallDisk {
 public:
  SmallDisk(std::filesystem::path folder, std::uintmax_t pages)
      : folder_(emptyFolder(std::move(folder))) {
    const std::string size = fmt::format("size={}", std::max(pages, std::uintmax_t{1}) * kPage);
    if (mount("none", folder_.c_str(), "tmpfs", 0, size.c_str()) != 0) {
      throw InputError("disk: only root can mount small disks");
    }
  }
  ~SmallDisk() { umount(folder_.c_str()); }
  SmallDisk(const SmallDisk&) = delete;
  SmallDisk& operator=(const SmallDisk&) = delete;

 private:
  std::filesystem::path folder_;
};

}  // namespace

std::string fillDisks(const DisturbedPlace& place, bool& isWell) {
  const auto output = place.folder / "output";
  ChildProcess(place.program, runInto(place, place.folder / "roomy"), output).exitCode();
  const std::vector<WrittenFile> files = listWritten(place.folder / "roomy");
  const std::filesystem::path out = place.folder / "small";
  std::uintmax_t before = 0;
  std::string rows;
  int asItShould = 0;
  for (const WrittenFile& file : files) {
    const SmallDisk disk(out, before + file.pages - 1);
    before += file.pages;
    ChildProcess run(place.program, runInto(place, out), output);
    const int exitCode = run.exitCode();
    const std::string told = run.output();
    const bool isNamed = told.find("/" + file.name + ": cannot be written") != told.npos;
    const std::size_t written = listWritten(out).size();
    const std::size_t half =
        listHalfFiles(out).size() + static_cast<std::size_t>(countTemporaries(out));
    const bool hasReport =
        file.name == "report.json" || std::filesystem::exists(out / "report.json");
    const bool isRight = exitCode == 5 && isNamed && half == 0 && hasReport;
    asItShould += isRight;
    rows += fmt::format("| {} | {} | {}{}{} | {} | {} of {} | {} |\n", file.name, file.pages * 4,
                        isRight ? "" : "**", exitCode, isRight ? "" : "**",
                        isNamed ? "yes" : "**no**", written, files.size(), half);
  }
  isWell = isWell && asItShould == static_cast<int>(files.size());
  return fmt::format(
      "### Full disks\n\n"
      "A run into a disk that is full at each of the {} files in turn, a page short of it: {} of "
      "{} "
      "ended with exit code 5, the report\nwritten before and all told that was lost, with nothing "
      "half left. Smaller files behind it may still fit.\n\n"
      "| full at | KiB | exit code | told | files written | half or temporary |\n"
      "| --- | --- | --- | --- | --- | --- |\n{}",
      files.size(), asItShould, files.size(), rows);
}

}  // namespace morphgrid
