#include "core/create_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

TEST(CreateFolder, MakesThoseAboveToo) {
  const TemporaryFolder folder;
  createFolder(folder / "a/b", "--out a/b");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "a/b"));
  createFolder(folder / "a/b", "--out a/b");  // Is there already.
}

TEST(CreateFolder, NamesWhatTheUserGave) {
  const TemporaryFolder folder;
  folder.write("file", "not a folder");
  try {
    createFolder(folder / "file/b", "--out file/b");
    FAIL() << "a file is no folder";
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), testing::StartsWith("--out file/b: the folder cannot be made: "));
  }
}

}  // namespace
}  // namespace morphgrid
