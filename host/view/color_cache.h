#pragma once
#include <chrono>

#include "render/grid_painter.h"
#include "view/coloring.h"

namespace morphgrid {

/// Colours of struts that the host computes, kept until they are out of date.
class ColorCache {
 public:
  /// Keeps a reference.
  explicit ColorCache(const Device& device) : device_(device) {}

  /// Null, and the legend of strains, where strains are shown.
  std::shared_ptr<const StrutShares> sharesFor(Coloring coloring, const ShownGrid& shown,
                                               const Snapshot& snapshot);
  /// The legend of the last colours.
  const Legend& legend() const { return legend_; }

 private:
  using Clock = std::chrono::steady_clock;

  bool isUpToDate(Coloring coloring, const ShownGrid& shown) const;

  const Device& device_;
  Coloring coloring_ = Coloring::strain;
  std::shared_ptr<const DeviceGrid> onDevice_;
  std::shared_ptr<const Eigen::Matrix3Xd> positions_;
  std::shared_ptr<const StrutShares> shares_;
  Legend legend_ = strainLegend();
  Legend shareLegend_;
  Clock::time_point made_;
};

}  // namespace morphgrid
