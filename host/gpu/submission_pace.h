#pragma once
#include <algorithm>
#include <atomic>

namespace morphgrid {

/// How much work one submission holds where a window shares the queue: its frames wait for those
/// before them. Work is counted in workgroups; how long they take is learned on the way. For
/// several threads.
class SubmissionPace {
 public:
  /// Work after which a submission should end.
  long most() const { return most_; }

  /// A frame goes to the queue; it has been drawn.
  void beginFrame() { ++frameEvents_; }
  void endFrame() { frameEvents_ += frameEvents_ % 2; }

  /// To be given to learn(): taken before the submission.
  long frameEvents() const { return frameEvents_; }

  /// A submission of so much work took so long. One that waited for a frame tells nothing.
  void learn(long work, double seconds, long frameEventsBefore) {
    if (frameEventsBefore % 2 == 1 || frameEvents_ != frameEventsBefore) {
      return;
    }
    if (seconds > kLongest) {
      most_ = std::max(kLeast, std::min(most_.load(), work) * 2 / 3);
    } else if (seconds < kLongest / 2 && work >= most_ / 2) {
      most_ = std::min(kMost, most_ * 5 / 4);
    }
  }

 private:
  static constexpr double kLongest = 0.012;  // Seconds: a part of a frame.
  static constexpr long kLeast = 64;
  static constexpr long kMost = 1L << 30;

  std::atomic<long> most_ = 1024;
  std::atomic<long> frameEvents_ = 0;  ///< Odd while a frame is drawn.
};

}  // namespace morphgrid
