#include "view/draw_list.h"

namespace morphgrid {
namespace {

constexpr int kLiveQuads = 2000;  // About so many a surface.

}  // namespace

void DrawList::govern(const DeviceGrid& grid) {
  if (!(grid.shape() == governed_) || grid.isFrame() != governsFrame_) {
    governed_ = grid.shape();
    governsFrame_ = grid.isFrame();
    governor_.begin(governed_, governsFrame_);
  }
}

void DrawList::addGrid(const ShownGrid& shown, const Detail& detail, const Snapshot& snapshot,
                       const ViewState& state) {
  DrawnGrid drawn{shown, {}, nullptr};
  drawn.look.isSurface = looksLikeSurface(stageOf(state, snapshot));
  drawn.look.style = detail.style;
  drawn.look.stride = detail.stride;
  drawn.look.mostQuads = kLiveQuads;
  if (isColored(state, snapshot)) {
    drawn.shares = colors_.sharesFor(state.coloring, shown, snapshot);
    legend_ = colors_.legend();
  }
  grids_.push_back(std::move(drawn));
}

void DrawList::collect(const Snapshot& snapshot, const ViewState& state, bool isStill) {
  grids_.clear();
  legend_.reset();
  const ShownStage stage = stageOf(state, snapshot);
  sampling_ = stage == ShownStage::sampling ? snapshot.sampling : nullptr;
  const auto& shown = gridOf(stage, snapshot);
  const bool isThere = shown && shown->onDevice;
  if (isThere) {
    govern(*shown->onDevice);
  }
  governor_.keepTo(state.strutStyle);
  pictureStyle_ =
      state.strutStyle.value_or(isThere ? pictureStyleOf(*shown->onDevice) : StrutStyle::ribbons);
  const Detail detail = isStill ? governor_.still() : governor_.detail();
  samples_ = detail.samples;
  if (!isThere) {
    return;
  }
  addGrid(*shown, detail, snapshot, state);
  const auto& target = gridOf(ShownStage::target, snapshot);
  if (state.showsTarget && target && stage != ShownStage::target) {
    grids_.push_back(
        {*target, {.isSurface = true, .isVeil = true, .mostQuads = kLiveQuads}, nullptr});
  }
}

}  // namespace morphgrid
