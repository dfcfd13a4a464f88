#include "tests/app/subprocess.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <chrono>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "tests/support/folders.h"

namespace morphgrid {
namespace {

[[noreturn]] void becomeMorphgrid(std::vector<std::string> arguments,
                                  const std::vector<std::string>& environment, int output) {
  dup2(output, STDOUT_FILENO);
  dup2(output, STDERR_FILENO);
  for (const std::string& variable : environment) {
    const auto equals = variable.find('=');
    setenv(variable.substr(0, equals).c_str(), variable.substr(equals + 1).c_str(), 1);
  }
  arguments.insert(arguments.begin(), binaryFolder() / "morphgrid");
  std::vector<char*> pointers;
  for (std::string& argument : arguments) {
    pointers.push_back(argument.data());
  }
  pointers.push_back(nullptr);
  execv(pointers[0], pointers.data());
  _exit(127);
}

/// Kept by one thread, seen by another.
class Output {
 public:
  void append(const char* text, std::size_t size) {
    const std::lock_guard lock(mutex_);
    text_.append(text, size);
  }
  std::string text() const {
    const std::lock_guard lock(mutex_);
    return text_;
  }

 private:
  mutable std::mutex mutex_;
  std::string text_;
};

/// meddle(child, output, ended) runs beside the program and returns once `ended`.
ProcessResult runWith(
    const std::vector<std::string>& arguments, const std::vector<std::string>& environment,
    const std::function<void(pid_t, const Output&, const std::atomic<bool>&)>& meddle) {
  std::array<int, 2> ends{};
  if (pipe(ends.data()) != 0) {
    throw std::runtime_error("pipe failed");
  }
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    becomeMorphgrid(arguments, environment, ends[1]);
  }
  close(ends[1]);
  std::atomic<bool> ended = false;
  Output output;
  std::thread meddler([&] { meddle(child, output, ended); });
  std::array<char, 4096> buffer{};
  for (ssize_t count = 0; (count = read(ends[0], buffer.data(), buffer.size())) > 0;) {
    output.append(buffer.data(), static_cast<std::size_t>(count));
  }
  close(ends[0]);
  ended = true;
  meddler.join();
  int status = 0;
  waitpid(child, &status, 0);
  return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), output.text()};
}

/// Waits until `done` or `ended`; returns whether it was the former.
bool waitFor(const std::function<bool()>& done, const std::atomic<bool>& ended) {
  while (!ended) {
    if (done()) {
      return true;
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

}  // namespace

ProcessResult runMorphgrid(const std::vector<std::string>& arguments,
                           const std::vector<std::string>& environment,
                           double interruptAfterSeconds) {
  using Clock = std::chrono::steady_clock;
  const auto end = Clock::now() + std::chrono::duration<double>(interruptAfterSeconds);
  const auto isTime = [&] { return Clock::now() >= end; };
  return runWith(arguments, environment,
                 [&](pid_t child, const Output&, const std::atomic<bool>& ended) {
                   if (interruptAfterSeconds > 0 && waitFor(isTime, ended)) {
                     kill(child, SIGINT);
                   }
                 });
}

ProcessResult runMorphgridUntil(const std::function<bool(const std::string& output)>& done,
                                const std::vector<std::string>& arguments, int signal) {
  return runWith(arguments, {},
                 [&](pid_t child, const Output& output, const std::atomic<bool>& ended) {
                   if (waitFor([&] { return done(output.text()); }, ended)) {
                     kill(child, signal);
                   }
                 });
}

}  // namespace morphgrid
