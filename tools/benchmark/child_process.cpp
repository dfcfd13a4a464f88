#include "benchmark/child_process.h"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <stdexcept>
#include <thread>

#include "core/read_file.h"

namespace morphgrid {
namespace {

[[noreturn]] void becomeProgram(const std::filesystem::path& program,
                                std::vector<std::string> arguments,
                                const std::filesystem::path& output) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  const int file = open(output.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0644);
  dup2(file, STDOUT_FILENO);
  dup2(file, STDERR_FILENO);
  arguments.insert(arguments.begin(), program);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  execv(pointers[0], pointers.data());
  _exit(127);
}

}  // namespace

ChildProcess::ChildProcess(const std::filesystem::path& program,
                           const std::vector<std::string>& arguments,
                           const std::filesystem::path& output)
    : process_(fork()), output_(output) {
  if (process_ < 0) throw std::runtime_error("no process can be started");
  if (process_ == 0) becomeProgram(program, arguments, output);
}

ChildProcess::~ChildProcess() {
  if (hasEnded()) return;
  signal(SIGKILL);
  exitCode();
}

std::string ChildProcess::output() const {
  return std::filesystem::exists(output_) ? readFile(output_) : "";
}

void ChildProcess::signal(int number) const { kill(process_, number); }

bool ChildProcess::await(int options) {
  rusage usage{};
  if (wait4(process_, &status_, options, &usage) != process_) return false;
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  cost_ = {seconds(usage.ru_utime) + seconds(usage.ru_stime),
           1.024e-3 * static_cast<double>(usage.ru_maxrss)};
  return true;
}

bool ChildProcess::hasEnded() {
  hasEnded_ = hasEnded_ || await(WNOHANG);
  return hasEnded_;
}

bool ChildProcess::waitFor(const std::function<bool()>& done) {
  while (!hasEnded()) {
    if (done()) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  return false;
}

int ChildProcess::exitCode() {
  hasEnded_ = hasEnded_ || await(0);
  return WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_);
}

}  // namespace morphgrid
