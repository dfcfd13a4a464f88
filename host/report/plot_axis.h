#pragma once
#include <vector>

#include "report/plot.h"

namespace morphgrid {

/// The range of an axis: whole decades, or a few round steps.
class PlotAxis {
 public:
  /// Around the values that the scale can show; 0 to 1 or one decade where there are none.
  PlotAxis(PlotScale scale, const std::vector<double>& values);

  /// From 0 at the beginning to 1 at the end.
  double share(double value) const;

  /// Values with a line and a number, from the first to the last.
  const std::vector<double>& ticks() const { return ticks_; }

 private:
  PlotScale scale_;
  std::vector<double> ticks_;
};

/// Whether a scale has a place for it.
bool canShow(PlotScale scale, double value);

}  // namespace morphgrid
