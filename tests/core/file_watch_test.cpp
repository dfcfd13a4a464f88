#include "core/file_watch.h"

#include <gtest/gtest.h>

#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using std::chrono_literals::operator""s;

TEST(FileWatch, OfNothingNeverChanges) { EXPECT_FALSE(FileWatch().hasChanged()); }

TEST(FileWatch, TellsThatOneOfTheFilesIsNewer) {
  const TemporaryFolder folder;
  const auto first = folder.write("first", "a");
  const auto second = folder.write("second", "b");
  const FileWatch watch({first, second});
  EXPECT_FALSE(watch.hasChanged());
  std::filesystem::last_write_time(second, std::filesystem::last_write_time(second) + 1s);
  EXPECT_TRUE(watch.hasChanged());
  EXPECT_FALSE(FileWatch({first, second}).hasChanged());
}

TEST(FileWatch, TellsThatAnOlderFileTookItsPlace) {
  const TemporaryFolder folder;
  const auto file = folder.write("file", "a");
  const FileWatch watch({file});
  std::filesystem::last_write_time(file, std::filesystem::last_write_time(file) - 1s);
  EXPECT_TRUE(watch.hasChanged());
}

TEST(FileWatch, TellsThatAFileIsGoneOrHasComeToBe) {
  const TemporaryFolder folder;
  const auto file = folder.write("file", "a");
  const FileWatch present({file});
  std::filesystem::remove(file);
  EXPECT_TRUE(present.hasChanged());
  const FileWatch absent({file});
  EXPECT_FALSE(absent.hasChanged());
  folder.write("file", "a");
  EXPECT_TRUE(absent.hasChanged());
}

}  // namespace
}  // namespace morphgrid
