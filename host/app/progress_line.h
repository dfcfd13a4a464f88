#pragma once
#include <chrono>
#include <string>
#include <vector>

#include "solve/equilibrium.h"

namespace morphgrid {

/// Tells on stderr how a stage gets on: a bar that redraws itself on a terminal, a plain line every
/// few seconds elsewhere.
class ProgressLine {
 public:
  ProgressLine(std::string stage, double tolerance);
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void update(const ConvergenceSample& sample);
  /// After so many seconds, with so many to come (negative: unknown).
  void tell(const std::string& what, double seconds, double secondsLeft);

 private:
  std::string stage_;
  double tolerance_;
  bool onTerminal_;
  bool barDrawn_ = false;
  double lastPrinted_ = 0;  ///< Seconds since the stage began.
  std::vector<ConvergenceSample> samples_;
};

/// Seconds until the residual meets the tolerance, judged by its fall over the last half of the
/// time on this grid; negative when it does not fall, or too few samples tell.
double estimateSecondsLeft(const std::vector<ConvergenceSample>& samples, double tolerance);

}  // namespace morphgrid
