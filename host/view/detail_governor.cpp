#include "view/detail_governor.h"

#include <algorithm>
#include <cmath>

namespace morphgrid {
namespace {

// Seconds of a frame. Two of them must pass within a tenth of a second: an event that has just
// missed one is answered by the next.
constexpr double kLate = 0.040;
constexpr double kWanted = 0.030;
constexpr double kStill = 0.080;  // Of a frame that stays: still soon enough for an event.
// Without struts, and for a strut, about. Only ratios matter once frames are measured.
constexpr double kFrameCost = 0.018;
constexpr double kPlainFrameCost = 0.007;
constexpr double kRibbonCost = 2e-6;
constexpr double kPlainRibbonCost = 1e-6;
constexpr double kLineCost = 0.4e-6;
constexpr double kWorthwhile = 0.9;  // Of a level's cost: a coarser one that spares less is none.
constexpr int kFewestLines = 8;      // Each way.
constexpr int kFewestFrames = 6;     // At a level, before it is judged.
constexpr int kManyFrames = 40;      // At a level, before a finer one is tried.

double strutsDrawn(const GridShape& shape, int stride) {
  const GridShape drawn{(shape.verticesU - 2) / stride + 2, (shape.verticesV - 2) / stride + 2,
                        shape.layers};
  return drawn.strutCount();
}

}  // namespace

void DetailGovernor::begin(const GridShape& shape) {
  shape_ = shape;
  change(finestWithin(kWanted));
}

Detail DetailGovernor::still() const { return finestWithin(kStill); }

Detail DetailGovernor::finestWithin(double seconds) const {
  Detail detail{StrutStyle::ribbons, 4, 1};
  while (slowness_ * cost(detail) > seconds && !(coarser(detail) == detail)) {
    detail = coarser(detail);
  }
  return detail;
}

void DetailGovernor::change(const Detail& detail) {
  detail_ = detail;
  frames_ = 0;
  average_ = 0;
}

double DetailGovernor::cost(const Detail& detail) const {
  const double struts = strutsDrawn(shape_, detail.stride);
  if (detail.samples > 1) {
    return kFrameCost + kRibbonCost * struts;
  }
  return kPlainFrameCost +
         (detail.style == StrutStyle::lines ? kLineCost : kPlainRibbonCost) * struts;
}

Detail DetailGovernor::coarser(const Detail& detail) const {
  Detail next{StrutStyle::lines, 1, 2 * detail.stride};
  if (detail.samples > 1 || detail.style == StrutStyle::ribbons) {
    next = {detail.samples > 1 ? StrutStyle::ribbons : StrutStyle::lines, 1, 1};
  }
  const int shorterSide = std::min(shape_.verticesU, shape_.verticesV) - 1;
  const bool isTooCoarse = next.stride > 1 && next.stride * kFewestLines > shorterSide;
  return isTooCoarse || cost(next) > kWorthwhile * cost(detail) ? detail : next;
}

Detail DetailGovernor::finer(Detail detail) const {
  if (detail.stride > 1) {
    detail.stride /= 2;
    return detail;
  }
  return {StrutStyle::ribbons, detail.style == StrutStyle::lines ? 1 : 4, 1};
}

void DetailGovernor::update(double frameSeconds) {
  ++frames_;
  average_ += (frameSeconds - average_) / std::min(frames_, kFewestFrames);
  slowness_ += (frameSeconds / cost(detail_) - slowness_) / kManyFrames;
  if (frames_ >= kFewestFrames && average_ > kLate) {
    change(coarser(detail_));
  } else if (frames_ >= kManyFrames) {
    const Detail next = finer(detail_);
    if (!(next == detail_) && slowness_ * cost(next) < kWanted) {
      change(next);
    }
  }
}

}  // namespace morphgrid
