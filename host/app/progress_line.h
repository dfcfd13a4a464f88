#pragma once
#include <chrono>
#include <string>
#include <vector>

#include "solve/equilibrium.h"

namespace morphgrid {

/// How a stage lies in its run.
struct StageOutlook {
  double secondsBefore = 0;  ///< That the run has taken when the stage begins.
  double afterwards = 0;     ///< What follows takes, over what the stage takes: a guess.
};

/// Tells on stderr how a stage gets on: a bar that redraws itself on a terminal, a plain line every
/// few seconds elsewhere.
class ProgressLine {
 public:
  ProgressLine(std::string stage, double tolerance, StageOutlook outlook = {});
  ~ProgressLine();
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void update(const ConvergenceSample& sample);
  /// After so many seconds of the stage, with so many to come (negative: unknown): tells how many
  /// the run has to come.
  void tell(const std::string& what, double seconds, double secondsLeft);

 private:
  std::string stage_;
  double tolerance_;
  StageOutlook outlook_;
  bool onTerminal_;
  bool barDrawn_ = false;
  double lastPrinted_ = 0;  ///< Seconds since the stage began.
  std::vector<ConvergenceSample> samples_;
};

/// Seconds until the residual meets the tolerance, judged by its fall over the last half of the
/// samples on this grid and by what most of these took: one that waits for a kernel to be compiled
/// says nothing of the others. Negative when it does not fall, or too few samples tell.
double estimateSecondsLeft(const std::vector<ConvergenceSample>& samples, double tolerance);

}  // namespace morphgrid
