#include "tests/app/subprocess.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
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

}  // namespace

ProcessResult runMorphgrid(const std::vector<std::string>& arguments,
                           const std::vector<std::string>& environment,
                           double interruptAfterSeconds) {
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
  std::thread interrupter;
  if (interruptAfterSeconds > 0) {
    interrupter = std::thread([&] {
      std::this_thread::sleep_for(std::chrono::duration<double>(interruptAfterSeconds));
      kill(child, SIGINT);
    });
  }
  ProcessResult result{0, {}};
  std::array<char, 4096> buffer{};
  for (ssize_t count = 0; (count = read(ends[0], buffer.data(), buffer.size())) > 0;) {
    result.output.append(buffer.data(), static_cast<std::size_t>(count));
  }
  close(ends[0]);
  if (interrupter.joinable()) {
    interrupter.join();
  }
  int status = 0;
  waitpid(child, &status, 0);
  result.exitCode = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  return result;
}

}  // namespace morphgrid
