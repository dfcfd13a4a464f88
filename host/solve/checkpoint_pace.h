#pragma once
#include <chrono>

#include "solve/equilibrium.h"

namespace morphgrid {

/// Hands out checkpoints of a solve: as often as costs 1 % of its time, and one at the beginning of
/// each phase.
class CheckpointPace {
 public:
  /// Keeps a reference.
  explicit CheckpointPace(const SolveOptions& options) : options_(options) {}

  /// To be called after every step; make() returns the SolveCheckpoint. last: the solve ends
  /// here; what it does to leave a result is no state to go on from.
  template <typename Make>
  void offer(int phase, bool last, const Make& make) {
    const auto begin = Clock::now();
    if (!options_.onCheckpoint || ended_ || !(last || phase != phase_ || begin >= next_)) {
      return;
    }
    options_.onCheckpoint(make());
    const auto end = Clock::now();
    next_ = end + kPause * (end - begin);
    phase_ = phase;
    ended_ = last;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr int kPause = 99;  // Times what a checkpoint takes.

  const SolveOptions& options_;
  Clock::time_point next_;
  int phase_ = -1;  ///< Of the last one.
  bool ended_ = false;
};

}  // namespace morphgrid
