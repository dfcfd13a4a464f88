#include "app/guarded_action.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

#include "app/command_end.h"
#include "core/cancellation.h"
#include "core/output_error.h"
#include "core/read_file.h"
#include "tests/support/temporary_folder.h"

namespace morphgrid {
namespace {

using testing::StartsWith;

struct End {
  int code;
  std::string output;
};

template <typename Error>
End endOf(const Error& error) {
  testing::internal::CaptureStderr();
  const int code = runGuarded([&]() -> int { throw error; });
  return {code, testing::internal::GetCapturedStderr()};
}

TEST(GuardedAction, GivesItsOwnCode) {
  EXPECT_EQ(runGuarded([] { return 3; }), 3);
}

TEST(GuardedAction, TellsOfInputDevicesAndInterruption) {
  const End input = endOf(InputError("scene.toml:1:2: no"));
  EXPECT_EQ(input.code, kBadInput);
  EXPECT_EQ(input.output, "scene.toml:1:2: no\n");
  const End device = endOf(DeviceError("gone"));
  EXPECT_EQ(device.code, kDeviceFailure);
  EXPECT_EQ(device.output, "device failure: gone\n");
  EXPECT_EQ(endOf(Cancelled()).code, kInterrupted);
  const End output = endOf(OutputError("a.glb: cannot be written"));
  EXPECT_EQ(output.code, kOutputLost);
  EXPECT_EQ(output.output, "a.glb: cannot be written\n");
  const End folder = endOf(std::filesystem::filesystem_error(
      "cannot get it", std::make_error_code(std::errc::no_such_file_or_directory)));
  EXPECT_EQ(folder.code, kBadInput);
  EXPECT_THAT(folder.output, StartsWith("filesystem error: cannot get it"));
}

TEST(GuardedAction, OutOfMemoryIsOneLineHoweverItShows) {
  const std::system_error noThread(std::make_error_code(std::errc::resource_unavailable_try_again));
  for (const End& end : {endOf(std::bad_alloc()), endOf(std::bad_array_new_length()),
                         endOf(std::length_error("vector")), endOf(noThread)}) {
    EXPECT_EQ(end.code, kDeviceFailure);
    EXPECT_THAT(end.output, StartsWith("out of memory: "));
    EXPECT_EQ(std::count(end.output.begin(), end.output.end(), '\n'), 1);
  }
}

TEST(GuardedAction, MakesControlCharactersVisible) {
  EXPECT_EQ(endOf(InputError("a\x1b[2J.toml: no\nb: no")).output, "a\\x1b[2J.toml: no\nb: no\n");
}

/// How a process ends that prints to a file and would end with this code.
int endOfPrinting(const char* file, int exitCode, const Action& print) {
  const pid_t child = fork();
  if (child == 0) {
    if (!std::freopen(file, "w", stdout)) _exit(99);
    _exit(withOutputWritten(runGuarded([&] { return print() + exitCode; })));
  }
  int status = 0;
  waitpid(child, &status, 0);
  return WEXITSTATUS(status);
}

TEST(GuardedAction, LosesNoOutputUntold) {
  const Action line = [] { return fmt::print("line\n"), 0; };
  const Action more = [] { return fmt::print("{}\n", std::string(100000, 'x')), 0; };
  for (const Action& print : {line, more}) {
    EXPECT_EQ(endOfPrinting("/dev/null", kConverged, print), kConverged);
    EXPECT_EQ(endOfPrinting("/dev/full", kConverged, print), kOutputLost);
  }
  EXPECT_EQ(endOfPrinting("/dev/full", kNotConverged, line), kOutputLost);
  EXPECT_EQ(endOfPrinting("/dev/full", kDeviceFailure, line), kDeviceFailure);
}

TEST(GuardedAction, ClosedStreamsAreNotTakenForFiles) {
  const TemporaryFolder folder;
  const auto file = folder.write("f", "whole");
  const pid_t child = fork();
  if (child == 0) {
    close(STDOUT_FILENO);
    reserveStandardStreams();
    const int opened = open(file.c_str(), O_WRONLY);
    fmt::print("table");
    _exit(opened == STDOUT_FILENO ? 98 : withOutputWritten(kConverged));
  }
  int status = 0;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), kOutputLost);
  EXPECT_EQ(readFile(file), "whole");
}

TEST(GuardedAction, ThrowsOnWhatIsABug) {
  EXPECT_THROW(runGuarded([]() -> int { throw std::logic_error("bug"); }), std::logic_error);
}

}  // namespace
}  // namespace morphgrid
