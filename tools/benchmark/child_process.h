#pragma once
#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

namespace morphgrid {

/// What a process that has ended took.
struct ProcessCost {
  double cpuSeconds = 0;     ///< Of all its threads, and of the system for them.
  double peakMegabytes = 0;  ///< Resident.
};

/// A program that runs; its output goes to a file. Killed where it still runs in the end.
class ChildProcess {
 public:
  /// Throws std::runtime_error when it cannot be started.
  ChildProcess(const std::filesystem::path& program, const std::vector<std::string>& arguments,
               const std::filesystem::path& output);
  ~ChildProcess();
  ChildProcess(const ChildProcess&) = delete;
  ChildProcess& operator=(const ChildProcess&) = delete;

  /// stdout and stderr so far.
  std::string output() const;

  void signal(int number) const;
  bool hasEnded();
  /// Until `done` or it ends; whether it was the former.
  bool waitFor(const std::function<bool()>& done);
  /// Until it ends; 128 + signal when a signal ended it.
  int exitCode();
  /// Once it has ended.
  const ProcessCost& cost() const { return cost_; }

 private:
  /// options: those of waitpid().
  bool await(int options);

  pid_t process_;
  std::filesystem::path output_;
  bool hasEnded_ = false;
  int status_ = 0;
  ProcessCost cost_;
};

}  // namespace morphgrid
