#pragma once
#include <chrono>
#include <functional>

namespace morphgrid {

/// Hands out checkpoints of long work: as often as costs 1 % of its time, and one at the beginning
/// of each phase.
template <typename Checkpoint>
class CheckpointPace {
 public:
  /// Keeps a reference to `take`, which gets the checkpoints; may be empty.
  explicit CheckpointPace(const std::function<void(Checkpoint)>& take) : take_(take) {}

  /// To be called after every step; make() returns the checkpoint. last: the work ends here; what
  /// it does to leave a result is no state to go on from.
  template <typename Make>
  void offer(int phase, bool last, const Make& make) {
    const auto begin = Clock::now();
    if (!take_ || ended_ || !(last || phase != phase_ || begin >= next_)) {
      return;
    }
    take_(make());
    const auto end = Clock::now();
    next_ = end + kPause * (end - begin);
    phase_ = phase;
    ended_ = last;
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr int kPause = 99;  // Times what a checkpoint takes.

  const std::function<void(Checkpoint)>& take_;
  Clock::time_point next_;
  int phase_ = -1;  ///< Phase of the last checkpoint.
  bool ended_ = false;
};

}  // namespace morphgrid
