#pragma once
#include "view/color_cache.h"
#include "view/scene_view.h"
#include "view/view_state.h"

namespace morphgrid {

/// What of a snapshot a frame draws, and how finely.
class DrawList {
 public:
  /// Keeps a reference.
  explicit DrawList(const Device& device) : colors_(device) {}

  /// As the user has chosen. isStill: nothing moves, so that the frame may take longer.
  void collect(const Snapshot& snapshot, const ViewState& state, bool isStill);
  /// How long the last frame took that was not still, in seconds.
  void noteFrame(double seconds) { governor_.update(seconds); }

  const std::vector<DrawnGrid>& grids() const { return grids_; }
  /// Null unless that is what is shown.
  const std::shared_ptr<const MeshSampling>& sampling() const { return sampling_; }
  int samples() const { return samples_; }  ///< Samples a pixel.
  /// The style of struts in a picture that may take its time.
  StrutStyle pictureStyle() const { return pictureStyle_; }
  /// The legend of what is shown; none where colours mean nothing.
  const std::optional<Legend>& legend() const { return legend_; }

 private:
  void govern(const DeviceGrid& grid);
  void addGrid(const ShownGrid& shown, const Detail& detail, const Snapshot& snapshot,
               const ViewState& state);

  ColorCache colors_;
  GridShape governed_{2, 2, 1};
  bool governsFrame_ = false;
  DetailGovernor governor_{governed_};
  std::vector<DrawnGrid> grids_;
  std::shared_ptr<const MeshSampling> sampling_;
  std::optional<Legend> legend_;
  int samples_ = 1;
  StrutStyle pictureStyle_ = StrutStyle::ribbons;
};

}  // namespace morphgrid
