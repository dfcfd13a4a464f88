#include "view/detail_governor.h"

#include <algorithm>

namespace morphgrid {
namespace {

// Seconds of a frame. Two of them must pass within a tenth of a second, slow ones too: an event
// that has just missed one is answered by the next.
constexpr double kLate = 0.030;
constexpr double kWanted = 0.024;
constexpr double kStill = 0.080;  // Seconds for a frame that stays: still soon enough for an event.

/// What a frame takes with so many samples a pixel, about, in seconds. Only ratios matter once
/// frames are measured.
struct FrameCost {
  double withoutStruts;
  std::array<double, 3> strut;  ///< Indexed by StrutStyle.
};
constexpr FrameCost kPlainCost{0.007, {0.4e-6, 1e-6, 2.7e-6}};  // One sample.
constexpr FrameCost kSmoothCost{0.018, {0.5e-6, 2e-6, 6e-6}};   // Four samples.
constexpr double kBarOverTube = 2;                              // What a bar costs of a tube.
// Share of a level's cost: a coarser level that costs more than that is left out.
constexpr double kWorthwhile = 0.9;
constexpr int kFewestLines = 8;   // Each way.
constexpr int kFewestFrames = 6;  // At a level, before it is judged.
constexpr int kManyFrames = 40;   // At a level, before a finer one is tried.

double strutsDrawn(const GridShape& shape, int stride) {
  const GridShape drawn{(shape.verticesU - 2) / stride + 2, (shape.verticesV - 2) / stride + 2,
                        shape.layers};
  return drawn.strutCount();
}

/// From the finest to the coarsest, were there time for all of them or for none.
std::vector<Detail> candidates(const GridShape& shape, std::optional<StrutStyle> style) {
  std::vector<Detail> levels = {{StrutStyle::tubes, 4, 1},
                                {StrutStyle::ribbons, 4, 1},
                                {StrutStyle::ribbons, 1, 1},
                                {StrutStyle::lines, 1, 1}};
  if (style) {
    levels = {{*style, 4, 1}, {*style, 1, 1}};
  }
  const int shorterSide = std::min(shape.verticesU, shape.verticesV) - 1;
  if (levels.back().style == StrutStyle::lines) {
    for (int stride = 2; stride * kFewestLines <= shorterSide; stride *= 2) {
      levels.push_back({StrutStyle::lines, 1, stride});
    }
  }
  return levels;
}

}  // namespace

void DetailGovernor::begin(const GridShape& shape, bool isFrame) {
  shape_ = shape;
  isFrame_ = isFrame;
  restart();
}

void DetailGovernor::keepTo(std::optional<StrutStyle> style) {
  if (style != style_) {
    style_ = style;
    restart();
  }
}

void DetailGovernor::restart() {
  levels_ = listLevels();
  change(finestWithin(kWanted));
}

Detail DetailGovernor::still() const { return levels_[finestWithin(kStill)]; }

std::vector<Detail> DetailGovernor::listLevels() const {
  std::vector<Detail> levels;
  for (const Detail& detail : candidates(shape_, style_)) {
    if (levels.empty() || cost(detail) <= kWorthwhile * cost(levels.back())) {
      levels.push_back(detail);
    }
  }
  return levels;
}

double DetailGovernor::cost(const Detail& detail) const {
  const FrameCost& frame = detail.samples > 1 ? kSmoothCost : kPlainCost;
  const double relative = isFrame_ && detail.style == StrutStyle::tubes ? kBarOverTube : 1;
  return frame.withoutStruts + relative * frame.strut[static_cast<std::size_t>(detail.style)] *
                                   strutsDrawn(shape_, detail.stride);
}

std::size_t DetailGovernor::finestWithin(double seconds) const {
  std::size_t level = 0;
  while (level + 1 < levels_.size() && slowness_ * cost(levels_[level]) > seconds) {
    ++level;
  }
  return level;
}

void DetailGovernor::change(std::size_t level) {
  level_ = level;
  frames_ = 0;
  average_ = 0;
}

void DetailGovernor::update(double frameSeconds) {
  ++frames_;
  average_ += (frameSeconds - average_) / std::min(frames_, kFewestFrames);
  slowness_ += (frameSeconds / cost(detail()) - slowness_) / kManyFrames;
  if (frames_ >= kFewestFrames && average_ > kLate) {
    change(std::min(level_ + 1, levels_.size() - 1));
  } else if (frames_ >= kManyFrames && level_ > 0 &&
             slowness_ * cost(levels_[level_ - 1]) < kWanted) {
    change(level_ - 1);
  }
}

}  // namespace morphgrid
