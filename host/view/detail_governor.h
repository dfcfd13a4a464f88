#pragma once
#include "render/grid_painter.h"

namespace morphgrid {

/// How finely struts are drawn.
struct Detail {
  StrutStyle style;
  int samples;  ///< Of a pixel.
  int stride;   ///< Of lines, see GridLook.

  bool operator==(const Detail&) const = default;
};

/// Chooses the level of detail so that frames are not late: by the number of struts, then by how
/// long frames take.
class DetailGovernor {
 public:
  explicit DetailGovernor(const GridShape& shape) { begin(shape); }

  /// Another grid.
  void begin(const GridShape& shape);

  const Detail& detail() const { return detail_; }
  /// For a frame that stays: nothing moves, so that it may take longer.
  Detail still() const;

  /// How long the last frame took, in seconds.
  void update(double frameSeconds);

 private:
  double cost(const Detail& detail) const;
  /// The same where a coarser one would spare too little.
  Detail coarser(const Detail& detail) const;
  Detail finer(Detail detail) const;
  void change(const Detail& detail);
  Detail finestWithin(double seconds) const;

  GridShape shape_{};
  Detail detail_{};
  double average_ = 0;   ///< Of the frames at this level, in seconds.
  int frames_ = 0;       ///< At this level.
  double slowness_ = 1;  ///< What frames take over what they are expected to, of late.
};

}  // namespace morphgrid
