#include "core/on_interrupt.h"

#include <sys/time.h>
#include <time.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstring>

namespace morphgrid {
namespace {

// What a signal handler may use: atomics without locks, and few functions.
static_assert(std::atomic<const char*>::is_always_lock_free);
static_assert(std::atomic<InterruptAct>::is_always_lock_free);
static_assert(std::atomic<double>::is_always_lock_free);

// More than are ever written at once; the next run removes what a crowd beyond that leaves.
constexpr int kMostPending = 1024;
constexpr int kNoPlace = -1;

std::atomic<bool> interrupted = false;
std::atomic<double> interruptedAt = 0;  // As secondsNow() says.
std::atomic<InterruptAct> interruptAct = InterruptAct::stop;
std::atomic<const char*> interruptLine = "";
std::array<std::atomic<const char*>, kMostPending> pendingFiles{};

double secondsNow() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

void tellNow(const char* line) {
  if (*line == 0) return;
  // Nobody is there to tell that this fails.
  [[maybe_unused]] auto told = write(STDERR_FILENO, "\n", isatty(STDERR_FILENO) ? 1 : 0);
  told = write(STDERR_FILENO, line, std::strlen(line));
  told = write(STDERR_FILENO, "\n", 1);
}

[[noreturn]] void endNow() {
  for (std::atomic<const char*>& file : pendingFiles) {
    if (const char* path = file.exchange(nullptr)) unlink(path);
  }
  _exit(kInterruptedCode);
}

void onInterrupt(int) {
  const int before = errno;
  if (!interrupted) interruptedAt = secondsNow();
  const bool isSecond = interrupted.exchange(true);
  if (isSecond) {
    tellNow("interrupted again: the rest is dropped");
    endNow();
  }
  tellNow(interruptLine);
  if (interruptAct == InterruptAct::end) endNow();
  errno = before;
}

void onTimeUp(int) {
  tellNow(interruptLine);
  endNow();
}

}  // namespace

void installInterruptHandler() {
  std::signal(SIGINT, onInterrupt);
  std::signal(SIGTERM, onInterrupt);
}

bool interruptRequested() { return interrupted; }

double secondsSinceInterrupt() { return interrupted ? secondsNow() - interruptedAt : 0; }

OnInterrupt::OnInterrupt(InterruptAct act, const char* line)
    : actBefore_(interruptAct.exchange(act)), lineBefore_(interruptLine.exchange(line)) {}

OnInterrupt::~OnInterrupt() {
  interruptAct = actBefore_;
  interruptLine = lineBefore_;
}

void endIn(double seconds) {
  std::signal(SIGALRM, onTimeUp);
  const double whole = std::floor(seconds);
  const itimerval timer{
      .it_interval = {},
      .it_value = {static_cast<time_t>(whole), static_cast<suseconds_t>(1e6 * (seconds - whole))}};
  setitimer(ITIMER_REAL, &timer, nullptr);
}

int removeWhenEnded(const char* path) {
  for (int number = 0; number < kMostPending; ++number) {
    const char* none = nullptr;
    if (pendingFiles[static_cast<std::size_t>(number)].compare_exchange_strong(none, path)) {
      return number;
    }
  }
  return kNoPlace;
}

void keepWhenEnded(int number) {
  if (number != kNoPlace) pendingFiles[static_cast<std::size_t>(number)] = nullptr;
}

}  // namespace morphgrid
