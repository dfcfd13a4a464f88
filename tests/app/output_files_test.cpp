#include "app/output_files.h"

#include <gmock/gmock.h>

#include <new>

#include "core/atomic_file.h"
#include "core/output_error.h"
#include "core/read_file.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

void writeWord(const std::filesystem::path& file) { writeFileAtomically(file, "word"); }

TEST(OutputFiles, OneThatCannotBeWrittenKeepsNoOtherFromIt) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "b.txt");
  OutputFiles files(folder.path(), true);
  for (const char* name : {"a.txt", "b.txt", "missing/c.txt", "d.txt"}) {
    files.write(name, writeWord);
  }
  EXPECT_THAT(files.written(), ElementsAre(folder / "a.txt", folder / "d.txt"));
  EXPECT_THAT(files.lost(),
              ElementsAre(HasSubstr("b.txt: cannot be written"), HasSubstr("c.txt: cannot be")));
  EXPECT_EQ(readFile(folder / "d.txt"), "word");
  EXPECT_TRUE(std::filesystem::is_directory(folder / "b.txt"));
}

TEST(OutputFiles, MemoryThatAFileLacksIsToldOfIt) {
  const TemporaryFolder folder;
  OutputFiles files(folder.path(), true);
  files.write("large.glb", [](const auto&) { throw std::bad_alloc(); });
  files.write("a.txt", writeWord);
  EXPECT_THAT(files.lost(), ElementsAre(HasSubstr("large.glb: cannot be written: out of memory")));
  EXPECT_THAT(files.written(), ElementsAre(folder / "a.txt"));
}

TEST(OutputFiles, OtherErrorsArePassedOn) {
  OutputFiles files({}, true);
  EXPECT_THROW(files.write("a", [](const auto&) { throw DeviceError("gone"); }), DeviceError);
  EXPECT_THROW(files.write("a", [](const auto&) { throw InputError("wrong"); }), InputError);
}

TEST(OutputFiles, OnesWrittenMeanwhileComeInTheirOrderAndAreAsWell) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder / "b.txt");
  OutputFiles files(folder.path(), true);
  for (const char* name : {"a.txt", "b.txt", "c.txt"}) files.writeMeanwhile(name, writeWord);
  files.write("d.txt", writeWord);
  files.writeMeanwhile("e.txt", writeWord);
  files.finish();
  EXPECT_THAT(files.written(),
              ElementsAre(folder / "a.txt", folder / "c.txt", folder / "d.txt", folder / "e.txt"));
  EXPECT_THAT(files.lost(), ElementsAre(HasSubstr("b.txt: cannot be written")));
}

TEST(OutputFiles, OtherErrorsOfOnesWrittenMeanwhileArePassedOnByTheNextCall) {
  OutputFiles files({}, true);
  files.writeMeanwhile("a", [](const auto&) { throw DeviceError("gone"); });
  EXPECT_THROW(files.finish(), DeviceError);
  files.writeMeanwhile("a", [](const auto&) { throw InputError("wrong"); });
  EXPECT_THROW(files.write("b", [](const auto&) {}), InputError);
}

}  // namespace
}  // namespace morphgrid
