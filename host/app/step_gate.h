#pragma once
#include <chrono>
#include <condition_variable>
#include <functional>
#include <mutex>

namespace morphgrid {

/// Holds a solver between its steps for those who look on: while they have paused it, and until a
/// frame has shown its last step.
class StepGate {
 public:
  /// A window that shows no frames, minimised or closing, must not stop the solver; nor may a
  /// wake() that comes just before a wait.
  static constexpr std::chrono::milliseconds kPatience{100};

  explicit StepGate(std::chrono::milliseconds patience = kPatience) : patience_(patience) {}

  void pause(bool isPaused);
  /// Pauses after one more step.
  void step();
  void showEveryStep(bool isShown);
  /// A frame has been shown.
  void noteFrame();
  /// isCancelled() may have changed.
  void wake() { changed_.notify_all(); }

  /// The solver calls this after each step, and is held here while paused; whilePaused is then
  /// called now and then.
  void pass(const std::function<bool()>& isCancelled, const std::function<void()>& whilePaused);

 private:
  void awaitLeave(std::unique_lock<std::mutex>& lock, const std::function<bool()>& isCancelled,
                  const std::function<void()>& whilePaused);

  std::chrono::milliseconds patience_;
  std::mutex mutex_;
  std::condition_variable changed_;
  bool isPaused_ = false;
  bool showsEveryStep_ = true;
  long leaves_ = 0;  ///< Steps that were asked for one by one.
  long frames_ = 0;
};

}  // namespace morphgrid
