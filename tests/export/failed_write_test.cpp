#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>

#include "core/output_error.h"
#include "export/gltf.h"
#include "export/surface_files.h"
#include "export/vtu.h"
#include "tests/export/export_samples.h"

namespace morphgrid {
namespace {

struct Format {
  std::string extension;
  std::function<void(const std::filesystem::path&, const ExportSample&)> write;
};

void PrintTo(const Format& format, std::ostream* stream) { *stream << format.extension; }

const Format kFormats[] = {
    {"glb", [](const auto& path,
               const ExportSample& s) { exportGltf(path, s.grid, s.positions, s.surface); }},
    {"vtu", [](const auto& path, const ExportSample& s) { exportVtu(path, s.grid, s.positions); }},
    {"printed_vtu",
     [](const auto& path, const ExportSample& s) {
       exportPrintedVtu(path, s.grid, s.positions, std::nullopt);
     }},
    {"ply", [](const auto& path, const ExportSample& s) { exportPly(path, s.surface); }},
    {"obj", [](const auto& path, const ExportSample& s) { exportObj(path, s.surface); }},
};

class FailedWrite : public testing::TestWithParam<Format> {
 protected:
  /// Expects an error that names the file, and nothing on the terminal.
  void expectRefused(const std::filesystem::path& path) {
    testing::internal::CaptureStderr();
    testing::internal::CaptureStdout();
    std::string message;
    try {
      GetParam().write(path, sample);
    } catch (const OutputError& error) {
      message = error.what();
    }
    EXPECT_THAT(message, testing::StartsWith(path.string() + ": cannot be written"));
    EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
    EXPECT_EQ(testing::internal::GetCapturedStderr(), "");
  }

  std::string name = "morph." + GetParam().extension;
  ExportSample sample = exportSample({5, 3, 2});
  TemporaryFolder folder;
};
INSTANTIATE_TEST_SUITE_P(Formats, FailedWrite, testing::ValuesIn(kFormats),
                         [](const auto& test) { return test.param.extension; });

TEST_P(FailedWrite, MissingFolderIsNamed) { expectRefused(folder / "missing" / name); }

TEST_P(FailedWrite, FolderOfTheSameNameIsKept) {
  std::filesystem::create_directory(folder / name);
  expectRefused(folder / name);
  EXPECT_TRUE(std::filesystem::is_directory(folder / name));
  EXPECT_EQ(folder.fileCount(), 1);
}

TEST_P(FailedWrite, FullDiskLeavesTheOldFile) {
  writeFile(folder / name, "what was there before");
  for (const int bytes : {0, 100, 600}) {
    const FullDisk disk(bytes);
    expectRefused(folder / name);
  }
  EXPECT_EQ(readFile(folder / name), "what was there before");
  EXPECT_EQ(folder.fileCount(), 1);
}

TEST_P(FailedWrite, ReadOnlyFolderLeavesTheOldFile) {
  using std::filesystem::perms;
  writeFile(folder / name, "what was there before");
  std::filesystem::permissions(
      folder / "", perms::owner_read | perms::owner_exec | perms::others_read | perms::others_exec);
  {
    const OrdinaryUser user;
    expectRefused(folder / name);
  }
  std::filesystem::permissions(folder / "", perms::owner_all);
  EXPECT_EQ(readFile(folder / name), "what was there before");
  EXPECT_EQ(folder.fileCount(), 1);
}

TEST_P(FailedWrite, SuccessReplacesTheOldFile) {
  writeFile(folder / name, "what was there before");
  GetParam().write(folder / name, sample);
  EXPECT_GT(readFile(folder / name).size(), 600);
  EXPECT_EQ(folder.fileCount(), 1);
}

}  // namespace
}  // namespace morphgrid
