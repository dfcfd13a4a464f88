#include "core/on_interrupt.h"

#include <gtest/gtest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <fstream>
#include <functional>
#include <thread>

#include "core/atomic_file.h"
#include "core/read_file.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

constexpr int kDone = 7;

struct Ended {
  int exitCode;
  std::string told;
};

/// How a process ends that does this, with handlers installed; stderr goes to a file.
Ended endOf(const TemporaryFolder& folder, const std::function<void()>& work) {
  const auto told = folder / "told";
  const pid_t child = fork();
  if (child == 0) {
    if (!std::freopen(told.c_str(), "w", stderr)) _exit(99);
    installInterruptHandler();
    work();
    _exit(kDone);
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_TRUE(WIFEXITED(status));
  Ended ended{WEXITSTATUS(status), readFile(told)};
  std::filesystem::remove(told);
  return ended;
}

void writeHalf(const PendingFile& file) { std::ofstream(file.path()) << "half"; }

TEST(Interrupt, AsksToStopAndGoesOn) {
  const TemporaryFolder folder;
  for (const int signal : {SIGINT, SIGTERM}) {
    const Ended ended = endOf(folder, [&] {
      const OnInterrupt saving(InterruptAct::stop, "interrupted: saving");
      if (interruptRequested()) _exit(98);
      raise(signal);
      if (!interruptRequested()) _exit(97);
    });
    EXPECT_EQ(ended.exitCode, kDone);
    EXPECT_EQ(ended.told, "interrupted: saving\n");
  }
}

TEST(Interrupt, EndsAtOnceWhereThereIsNothingToSave) {
  const TemporaryFolder folder;
  folder.write("file.txt", "before");
  const Ended ended = endOf(folder, [&] {
    const OnInterrupt ending(InterruptAct::end, "interrupted: nothing to save");
    const PendingFile file(folder / "file.txt");
    writeHalf(file);
    raise(SIGINT);
  });
  EXPECT_EQ(ended.exitCode, kInterruptedCode);
  EXPECT_EQ(ended.told, "interrupted: nothing to save\n");
  EXPECT_EQ(readFile(folder / "file.txt"), "before");
  EXPECT_EQ(folder.fileCount(), 1) << "no half file";
}

TEST(Interrupt, ASecondOneDropsWhatIsBeingSaved) {
  const TemporaryFolder folder;
  const Ended ended = endOf(folder, [&] {
    const OnInterrupt saving(InterruptAct::stop, "");
    const PendingFile one(folder / "one.txt"), two(folder / "two.txt");
    writeHalf(one);
    writeHalf(two);
    raise(SIGINT);
    raise(SIGTERM);
  });
  EXPECT_EQ(ended.exitCode, kInterruptedCode);
  EXPECT_EQ(folder.fileCount(), 0);
}

TEST(Interrupt, KeepsFilesThatAreComplete) {
  const TemporaryFolder folder;
  endOf(folder, [&] {
    const OnInterrupt ending(InterruptAct::end, "");
    writeFileAtomically(folder / "whole.txt", "whole");
    {
      const PendingFile given(folder / "given up.txt");  // Its place is free again.
    }
    raise(SIGINT);
  });
  EXPECT_EQ(readFile(folder / "whole.txt"), "whole");
}

TEST(Interrupt, DoesWhatTheInnermostScopeSays) {
  const TemporaryFolder folder;
  const Ended ended = endOf(folder, [] {
    const OnInterrupt outer(InterruptAct::stop, "outer");
    { const OnInterrupt inner(InterruptAct::end, "inner"); }
    raise(SIGINT);
  });
  EXPECT_EQ(ended.exitCode, kDone);
  EXPECT_EQ(ended.told, "outer\n");
}

TEST(Interrupt, IsTimedFromTheFirstOne) {
  const TemporaryFolder folder;
  const Ended ended = endOf(folder, [] {
    const OnInterrupt saving(InterruptAct::stop, "");
    if (secondsSinceInterrupt() != 0) std::abort();
    raise(SIGINT);
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
    const double seconds = secondsSinceInterrupt();
    if (seconds < 0.02 || seconds > 20) std::abort();
  });
  EXPECT_EQ(ended.exitCode, kDone);
}

TEST(Interrupt, TimeIsUpAsAfterASecondOne) {
  const TemporaryFolder folder;
  const auto wait = [] { std::this_thread::sleep_for(std::chrono::seconds(30)); };
  const Ended late = endOf(folder, [&] {
    const PendingFile file(folder / "file.txt");
    writeHalf(file);
    endIn(0.01);
    wait();
  });
  EXPECT_EQ(late.exitCode, kInterruptedCode);
  EXPECT_EQ(folder.fileCount(), 0);
  const Ended inTime = endOf(folder, [&] {
    endIn(0.05);
    endIn(0);
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  });
  EXPECT_EQ(inTime.exitCode, kDone);
}

}  // namespace
}  // namespace morphgrid
