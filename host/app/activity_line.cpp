#include "app/activity_line.h"

#include <fmt/format.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>

namespace morphgrid {
namespace {

constexpr std::chrono::seconds kUnnoticed(1);
constexpr std::chrono::seconds kBetweenRedraws(1);
constexpr std::chrono::seconds kBetweenLines(5);

}  // namespace

ActivityLine::ActivityLine(std::string what, bool quiet)
    : what_(std::move(what)), onTerminal_(isatty(STDERR_FILENO) != 0) {
  if (!quiet) watcher_ = std::thread([this] { watch(); });
}

ActivityLine::~ActivityLine() {
  {
    const std::lock_guard lock(mutex_);
    hasEnded_ = true;
  }
  ended_.notify_one();
  if (watcher_.joinable()) watcher_.join();
}

void ActivityLine::watch() {
  const auto start = std::chrono::steady_clock::now();
  std::unique_lock lock(mutex_);
  bool isTold = false;
  auto next = start + kUnnoticed;
  while (!ended_.wait_until(lock, next, [this] { return hasEnded_; })) {
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    fmt::print(stderr, "{}{}: {:.0f} s so far{}", onTerminal_ ? "\r\033[K" : "", what_,
               seconds.count(), onTerminal_ ? "" : "\n");
    std::fflush(stderr);
    isTold = true;
    next += onTerminal_ ? kBetweenRedraws : kBetweenLines;
  }
  if (isTold && onTerminal_) std::fputs("\r\033[K", stderr);
}

}  // namespace morphgrid
