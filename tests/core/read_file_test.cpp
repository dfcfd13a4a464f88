#include "core/read_file.h"

#include <gmock/gmock.h>
#include <sys/stat.h>

#include "core/array_file.h"
#include "core/error.h"
#include "core/toml_document.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

template <typename Action>
std::string problemOf(const TemporaryFolder& folder, const Action& action) {
  try {
    action();
  } catch (const InputError& error) {
    return folder.withoutPath(error.what());
  }
  return "";
}

TEST(ReadFile, GivesAllBytes) {
  const TemporaryFolder folder;
  const std::string bytes("a\0\r\n\xff", 5);
  EXPECT_EQ(readFile(folder.write("f", bytes)), bytes);
  std::filesystem::create_symlink("f", folder / "link");
  EXPECT_EQ(readFile(folder / "link", 5), bytes);
}

TEST(ReadFile, RefusesMoreThanIsAskedFor) {
  const TemporaryFolder folder;
  const auto file = folder.write("f", "12345");
  EXPECT_EQ(problemOf(folder, [&] { readFile(file, 4); }), "f: must be of 4 bytes at most, got 5");
}

TEST(ReadFile, RefusesWhatIsNoRegularFile) {
  const TemporaryFolder folder;
  ASSERT_EQ(mkfifo((folder / "pipe").c_str(), 0600), 0);
  for (const auto& file : {folder / "pipe", std::filesystem::path("/dev/zero")}) {
    const std::string name = folder.withoutPath(file.string());
    const std::string refusal = name + ": cannot be read: it is no regular file";
    EXPECT_EQ(problemOf(folder, [&] { readFile(file); }), refusal);
    EXPECT_EQ(problemOf(folder, [&] { parseToml(file); }), refusal);
    EXPECT_EQ(problemOf(folder, [&] { ArrayFile(file, {"n", 1, "noun", "advice"}); }), refusal);
  }
  EXPECT_EQ(problemOf(folder, [&] { readFile(folder.path()); }),
            folder.path().string() + ": cannot be read: it is a folder");
}

TEST(ReadFile, RefusesScenesOfManyMegabytes) {
  const TemporaryFolder folder;
  const auto file = folder.write("large.toml", "");
  std::filesystem::resize_file(file, (1 << 24) + 1);  // Zeros that take no room.
  EXPECT_EQ(problemOf(folder, [&] { parseToml(file); }),
            "large.toml: must be of 16777216 bytes at most, got 16777217");
}

}  // namespace
}  // namespace morphgrid
