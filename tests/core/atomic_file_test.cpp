#include "core/atomic_file.h"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/error.h"
#include "core/read_file.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

/// The number of a process that has ended.
pid_t deadProcess() {
  const pid_t child = fork();
  if (child == 0) _exit(0);
  waitpid(child, nullptr, 0);
  return child;
}

TEST(AtomicFile, LeavesOneFileOfTheFinalName) {
  const TemporaryFolder folder;
  writeFileAtomically(folder.write("a.b.txt", "old"), "new");
  EXPECT_EQ(readFile(folder / "a.b.txt"), "new");
  EXPECT_EQ(folder.fileCount(), 1);
  EXPECT_THROW(writeFileAtomically(folder / "none" / "a.txt", "new"), InputError);
}

TEST(AtomicFile, RemovesWhatKilledRunsLeftOfIt) {
  const TemporaryFolder folder;
  const std::string dead = std::to_string(deadProcess());
  const std::string alive = std::to_string(getppid());
  folder.write(".warped." + dead + ".glb", "half");
  const std::string kept[] = {".warped." + alive + ".glb",
                              ".warped." + dead + ".vtu",
                              ".other." + dead + ".glb",
                              ".warped." + dead + "x.glb",
                              ".warped.0" + dead + ".glb",
                              ".warped.-1.glb",
                              ".warped..glb",
                              "warped." + dead + ".glb"};
  for (const std::string& name : kept) folder.write(name, "theirs");
  writeFileAtomically(folder / "warped.glb", "whole");
  EXPECT_FALSE(std::filesystem::exists(folder / (".warped." + dead + ".glb")));
  for (const std::string& name : kept) EXPECT_TRUE(std::filesystem::exists(folder / name)) << name;
  EXPECT_EQ(folder.fileCount(), static_cast<int>(std::size(kept)) + 1);
}

TEST(AtomicFile, RemovesNoFolderOfSuchAName) {
  const TemporaryFolder folder;
  const std::string name = ".warped." + std::to_string(deadProcess()) + ".glb";
  std::filesystem::create_directory(folder / name);
  writeFileAtomically(folder / "warped.glb", "whole");
  EXPECT_TRUE(std::filesystem::exists(folder / name));
}

}  // namespace
}  // namespace morphgrid
