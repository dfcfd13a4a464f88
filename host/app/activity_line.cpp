#include "app/activity_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <mutex>
#include <thread>

namespace morphgrid {
namespace {

constexpr std::chrono::seconds kUnnoticed(1);
constexpr std::chrono::seconds kBetweenRedraws(1);
constexpr std::chrono::seconds kBetweenLines(5);
constexpr const char* kClearLine = "\r\033[K";

}  // namespace

struct ActivityLine::State {
  std::string what;
  bool onTerminal = isatty(STDERR_FILENO) != 0;
  std::mutex mutex;
  std::condition_variable ended;
  bool hasEnded = false;
  bool isTold = false;
};

ActivityLine::ActivityLine(std::string what, bool quiet) : state_(std::make_shared<State>()) {
  state_->what = std::move(what);
  // Nobody waits for it: it ends soon after the activity has, without a word.
  if (!quiet) std::thread([state = state_] { watch(*state); }).detach();
}

ActivityLine::~ActivityLine() {
  {
    const std::lock_guard lock(state_->mutex);
    state_->hasEnded = true;
    if (state_->isTold && state_->onTerminal) std::fputs(kClearLine, stderr);
  }
  state_->ended.notify_one();
}

void ActivityLine::watch(State& state) {
  const auto start = std::chrono::steady_clock::now();
  std::unique_lock lock(state.mutex);
  auto next = start + kUnnoticed;
  while (!state.ended.wait_until(lock, next, [&] { return state.hasEnded; })) {
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    fmt::print(stderr, "{}{}: {:.0f} s so far{}", state.onTerminal ? kClearLine : "", state.what,
               seconds.count(), state.onTerminal ? "" : "\n");
    std::fflush(stderr);
    state.isTold = true;
    next += state.onTerminal ? kBetweenRedraws : kBetweenLines;
  }
}

}  // namespace morphgrid
