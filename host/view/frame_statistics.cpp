#include "view/frame_statistics.h"

#include <fmt/format.h>

#include <algorithm>

namespace morphgrid {

void FrameStatistics::add(bool isSolving, double seconds, double latency) {
  Tally& tally = tallies_[isSolving ? 1 : 0];
  ++tally.frames;
  tally.seconds += seconds;
  tally.slowest = std::max(tally.slowest, seconds);
  tally.longestLatency = std::max(tally.longestLatency, latency);
}

std::string FrameStatistics::toText() const {
  std::string text;
  for (const bool isSolving : {true, false}) {
    const Tally& tally = tallies_[isSolving ? 1 : 0];
    if (tally.frames > 0) {
      text += fmt::format(
          "{:<8} {:5.1f} frames a second over {:.1f} s, slowest {:3.0f} ms, input answered within "
          "{:3.0f} ms\n",
          isSolving ? "solving:" : "at rest:", double(tally.frames) / tally.seconds, tally.seconds,
          1e3 * tally.slowest, 1e3 * tally.longestLatency);
    }
  }
  return text;
}

}  // namespace morphgrid
