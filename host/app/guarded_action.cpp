#include "app/guarded_action.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <new>
#include <stdexcept>
#include <system_error>

#include "app/command_end.h"
#include "core/cancellation.h"
#include "core/output_error.h"
#include "core/visible_text.h"
#include "gpu/device_failure.h"

namespace morphgrid {
namespace {

int failedWith(ExitCode code, const std::string& message) {
  fmt::print(stderr, "{}\n", visibleText(message, "\n\t"));
  return code;
}

int outOfMemory() {
  return failedWith(kDeviceFailure,
                    "out of memory: the grid, its target or its pictures do not fit; ask for "
                    "fewer nodes (grid.nodes_long) or free some memory");
}

/// Threads need memory for their stacks.
bool isOutOfMemory(const std::system_error& error) {
  return error.code() == std::errc::not_enough_memory ||
         error.code() == std::errc::resource_unavailable_try_again;
}

}  // namespace

int runGuarded(const Action& action) {
  try {
    return action();
  } catch (const OutputError& error) {
    return failedWith(kOutputLost, error.what());
  } catch (const InputError& error) {
    return failedWith(kBadInput, error.what());
  } catch (const DeviceError& error) {
    return failedWith(kDeviceFailure, fmt::format("device failure: {}", error.what()));
  } catch (const std::filesystem::filesystem_error& error) {
    return failedWith(kBadInput, error.what());
  } catch (const std::system_error& error) {
    if (std::ferror(stdout) != 0) return kOutputLost;  // withOutputWritten() tells.
    if (isDeviceFailure(error)) {
      return failedWith(kDeviceFailure, fmt::format("device failure: {}", error.what()));
    }
    if (isOutOfMemory(error)) return outOfMemory();
    throw;
  } catch (const Cancelled&) {
    return failedWith(kInterrupted, "interrupted before anything was solved");
  } catch (const std::bad_alloc&) {
    return outOfMemory();
  } catch (const std::length_error&) {  // What asks for more than there are addresses.
    return outOfMemory();
  }
}

int withOutputWritten(int exitCode) {
  const bool isWritten = std::fflush(stdout) == 0 && std::ferror(stdout) == 0;
  if (isWritten) return exitCode;
  const bool isSolved = exitCode == kConverged || exitCode == kNotConverged;
  const int code = isSolved ? kOutputLost : exitCode;
  return failedWith(static_cast<ExitCode>(code),
                    "standard output could not be written: is it closed, or its disk full?");
}

void reserveStandardStreams() {
  // Opened for reading alone, so that writing fails as it would on what is closed.
  for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
    if (fcntl(stream, F_GETFD) == -1) open("/dev/null", O_RDONLY);  // Takes the lowest number.
  }
}

}  // namespace morphgrid
