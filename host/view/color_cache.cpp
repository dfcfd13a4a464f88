#include "view/color_cache.h"

namespace morphgrid {
namespace {

constexpr std::chrono::milliseconds kColorPause(500);  // Between colours that follow a motion.

}  // namespace

bool ColorCache::isUpToDate(Coloring coloring, const ShownGrid& shown) const {
  if (!shares_ || onDevice_ != shown.onDevice || coloring_ != coloring) {
    return false;
  }
  return !followsMotion(coloring) || positions_ == shown.positions ||
         Clock::now() - made_ < kColorPause;
}

std::shared_ptr<const StrutShares> ColorCache::sharesFor(Coloring coloring, const ShownGrid& shown,
                                                         const Snapshot& snapshot) {
  if (coloring == Coloring::strain || !canColor(coloring, shown, snapshot)) {
    legend_ = strainLegend();
    onDevice_.reset();
    return nullptr;
  }
  if (!isUpToDate(coloring, shown)) {
    ColorShares colors = computeColors(coloring, shown, snapshot);
    shares_ = std::make_shared<StrutShares>(device_, colors.shares, colors.columns);
    shareLegend_ = std::move(colors.legend);
    coloring_ = coloring;
    onDevice_ = shown.onDevice;
    positions_ = shown.positions;
    made_ = Clock::now();
  }
  legend_ = shareLegend_;
  return shares_;
}

}  // namespace morphgrid
