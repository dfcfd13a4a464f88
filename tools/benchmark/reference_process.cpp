#include <poll.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <fstream>
#include <new>
#include <string>
#include <system_error>

#include "benchmark/solve_run.h"
#include "solve/frame_solver.h"
#include "solve/reference_solver.h"

namespace morphgrid {
namespace {

// The child's exit code is its StopReason, or one of these.
constexpr int kConverged = 100;
constexpr int kOutOfMemory = 101;
constexpr int kFailed = 102;

/// In bytes; 0 where /proc does not tell.
rlim_t procFigure(const char* file, const std::string& wanted) {
  std::ifstream stream(file);
  for (std::string key; stream >> key;) {
    rlim_t kibibytes = 0;
    if (key == wanted && stream >> kibibytes) {
      return kibibytes * 1024;
    }
  }
  return 0;
}

/// Beyond what is free now the kernel would kill, and not only this process.
void limitMemory() {
  const rlim_t bytes =
      procFigure("/proc/self/status", "VmSize:") + procFigure("/proc/meminfo", "MemAvailable:");
  const rlimit limit{bytes, bytes};
  setrlimit(RLIMIT_AS, &limit);
}

[[noreturn]] void solveInChild(const StrutGrid& grid, int pipe) {
  prctl(PR_SET_PDEATHSIG, SIGKILL);
  limitMemory();
  const auto send = [&](const ConvergenceSample& sample) {
    if (write(pipe, &sample, sizeof(sample)) != sizeof(sample)) {
      _exit(kFailed);
    }
  };
  int code = kFailed;
  try {
    SolveOptions options;
    options.onProgress = send;
    const Equilibrium result =
        grid.bars ? solveFrame(grid, options) : solveReference(grid, options);
    send({result.iterations, result.energy, result.residual, result.seconds});
    code = result.converged ? kConverged : static_cast<int>(result.reason);
  } catch (const std::bad_alloc&) {
    code = kOutOfMemory;
  } catch (const std::exception&) {
    code = kFailed;
  }
  _exit(code);
}

std::string describe(int status, bool anySample) {
  const std::string where = anySample ? "" : " while factorising";
  if (WIFSIGNALED(status)) {
    return std::string(strsignal(WTERMSIG(status))) + where;
  }
  switch (const int code = WEXITSTATUS(status)) {
    case kConverged:
      return "converged";
    case kOutOfMemory:
      return "out of memory" + where;
    case kFailed:
      return "failed" + where;
    default:
      return toString(static_cast<StopReason>(code));
  }
}

/// Whether there is something to read before `deadline`, a time of costSoFar().
bool waitForInput(int pipe, double deadline) {
  pollfd wanted{pipe, POLLIN, 0};
  for (;;) {
    const double left = std::max(0.0, deadline - costSoFar().wall);
    const int ready = poll(&wanted, 1, static_cast<int>(std::min(1000 * left + 1, 1e9)));
    if (ready > 0) {
      return true;
    }
    if (ready == 0 && costSoFar().wall >= deadline) {
      return false;
    }
    if (ready < 0 && errno != EINTR) {
      throw std::system_error(errno, std::generic_category(), "poll");
    }
  }
}

/// Until the child ends (true) or time is up.
bool readSamples(int pipe, double deadline, std::vector<ConvergenceSample>& history) {
  while (waitForInput(pipe, deadline)) {
    ConvergenceSample sample{};
    if (read(pipe, &sample, sizeof(sample)) != sizeof(sample)) {
      return true;
    }
    history.push_back(sample);
  }
  return false;
}

double cpuSeconds(const rusage& usage) {
  const auto seconds = [](const timeval& time) {
    return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

}  // namespace

SolveRun runReference(const StrutGrid& grid, double limit) {
  std::array<int, 2> pipeEnds{};
  if (pipe(pipeEnds.data()) != 0) {
    throw std::system_error(errno, std::generic_category(), "pipe");
  }
  const double start = costSoFar().wall;
  const pid_t child = fork();
  if (child < 0) {
    throw std::system_error(errno, std::generic_category(), "fork");
  }
  if (child == 0) {
    solveInChild(grid, pipeEnds[1]);
  }
  close(pipeEnds[1]);
  SolveRun run;
  const bool ended = readSamples(pipeEnds[0], start + limit, run.history);
  close(pipeEnds[0]);
  if (!ended) {
    kill(child, SIGKILL);
  }
  int status = 0;
  rusage usage{};
  wait4(child, &status, 0, &usage);
  run.cost = {costSoFar().wall - start, cpuSeconds(usage)};
  run.ending = ended ? describe(status, !run.history.empty())
                     : (run.history.empty() ? "time limit while factorising" : "time limit");
  return run;
}

}  // namespace morphgrid
