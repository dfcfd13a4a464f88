#pragma once
#include <array>
#include <string>

#include "view/session.h"

namespace morphgrid {

/// How smoothly a window runs.
class FrameStatistics {
 public:
  /// A frame that was shown `seconds` after the last one. latency: how long an event waited at most
  /// that came just after the last frame had looked for events.
  void add(bool isSolving, double seconds, double latency);

  /// Frames a second, the slowest frame, the longest latency; a line for each activity.
  std::string toText() const;

 private:
  struct Tally {
    long frames = 0;
    double seconds = 0;
    double slowest = 0;
    double longestLatency = 0;
  };

  std::array<Tally, 2> tallies_;  ///< At rest, solving.
};

}  // namespace morphgrid
