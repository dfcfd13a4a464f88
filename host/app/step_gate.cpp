#include "app/step_gate.h"

#include <algorithm>

namespace morphgrid {
void StepGate::pause(bool isPaused) {
  {
    const std::lock_guard lock(mutex_);
    isPaused_ = isPaused;
    leaves_ = 0;
  }
  wake();
}

void StepGate::step() {
  {
    const std::lock_guard lock(mutex_);
    isPaused_ = true;
    ++leaves_;
  }
  wake();
}

void StepGate::showEveryStep(bool isShown) {
  const std::lock_guard lock(mutex_);
  showsEveryStep_ = isShown;
}

void StepGate::noteFrame() {
  {
    const std::lock_guard lock(mutex_);
    ++frames_;
  }
  wake();
}

void StepGate::awaitLeave(std::unique_lock<std::mutex>& lock,
                          const std::function<bool()>& isCancelled,
                          const std::function<void()>& whilePaused) {
  while (isPaused_ && leaves_ == 0 && !isCancelled()) {
    lock.unlock();
    whilePaused();
    lock.lock();
    changed_.wait_for(lock, patience_, [&] { return !isPaused_ || leaves_ > 0 || isCancelled(); });
  }
  leaves_ = std::max(leaves_ - 1, 0L);
}

void StepGate::pass(const std::function<bool()>& isCancelled,
                    const std::function<void()>& whilePaused) {
  std::unique_lock lock(mutex_);
  awaitLeave(lock, isCancelled, whilePaused);
  if (showsEveryStep_) {
    // The frame under way may have begun before this step.
    const long seen = frames_ + 1;
    changed_.wait_for(lock, patience_, [&] { return frames_ > seen || isCancelled(); });
  }
}

}  // namespace morphgrid
