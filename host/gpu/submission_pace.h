#pragma once
#include <condition_variable>
#include <map>
#include <mutex>
#include <vector>

namespace morphgrid {

/// A call, by what it costs.
struct CallWork {
  const char* kernel;  ///< Static, known by its address.
  long groups;
};

/// How long submissions may be where a window shares the queue: its frames wait for those before
/// them. What a workgroup of each kernel takes is learned on the way. For several threads.
class SubmissionPace {
 public:
  /// What is submitted together should take no longer, in seconds: a part of a frame.
  static constexpr double kLongest = 0.008;
  /// What is recorded can be parted at least after so many workgroups.
  static constexpr long kMostGroups = 256;

  /// In seconds.
  double expect(const std::vector<CallWork>& work) const;

  /// Whether the kernel has run. At its first run it is compiled for good: enough for a submission.
  bool knows(const char* kernel) const;

  /// A frame goes to the queue; it has been drawn.
  void beginFrame();
  void endFrame();
  /// To be called before a submission: waits while a frame is drawn, which so finds the queue free.
  /// Not for long: a frame that failed has no end.
  void giveWay() const;

  /// To be given to learn(): taken before the submission.
  long frameEvents() const;

  /// A submission of so much work took so long. One that waited for a frame, or for the compiler,
  /// tells nothing.
  void learn(const std::vector<CallWork>& work, double seconds, long frameEventsBefore);

 private:
  double costOf(const CallWork& call) const;
  double sumCosts(const std::vector<CallWork>& work) const;
  bool meet(const std::vector<CallWork>& work);

  mutable std::mutex mutex_;
  mutable std::condition_variable frameEnded_;
  std::map<const char*, double> groupSeconds_;
  long frameEvents_ = 0;  ///< Odd while a frame is drawn.
};

}  // namespace morphgrid
