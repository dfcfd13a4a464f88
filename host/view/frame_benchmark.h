#pragma once
#include <chrono>

#include "view/frame_statistics.h"
#include "view/orbit_camera.h"

namespace morphgrid {

/// A user who turns the scene all the time and solves again whenever it is at rest; measures how
/// smoothly that goes.
class FrameBenchmark {
 public:
  /// seconds: how long it measures, after a while in which shaders are compiled.
  explicit FrameBenchmark(double seconds) : seconds_(seconds) {}

  /// A frame that was shown; see FrameStatistics::add().
  void noteFrame(const Snapshot& snapshot, double seconds, double latency);
  /// What the user does between frames.
  void act(const Snapshot& snapshot, Session& session, OrbitCamera& camera);
  bool isOver() const;
  std::string toText() const { return statistics_.toText(); }

 private:
  using Clock = std::chrono::steady_clock;

  double secondsOfMeasuring() const;

  double seconds_;
  FrameStatistics statistics_;
  Clock::time_point begun_ = Clock::now();
  Clock::time_point rested_ = Clock::now();  ///< Since when the scene is at rest.
};

}  // namespace morphgrid
