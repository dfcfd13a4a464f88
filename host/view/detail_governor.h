#pragma once
#include <optional>
#include <vector>

#include "render/grid_painter.h"

namespace morphgrid {

/// How finely struts are drawn.
struct Detail {
  StrutStyle style;
  int samples;  ///< Samples a pixel.
  int stride;   ///< Every n-th line is drawn, see GridLook.

  bool operator==(const Detail&) const = default;
};

/// Chooses the level of detail so that frames are not late: by the number of struts, then by how
/// long frames take.
class DetailGovernor {
 public:
  explicit DetailGovernor(const GridShape& shape) { begin(shape); }

  /// Another grid. isFrame: its tubes are bars.
  void begin(const GridShape& shape, bool isFrame = false);
  /// Keeps to a style, though frames be late; none: to no style.
  void keepTo(std::optional<StrutStyle> style);

  const Detail& detail() const { return levels_[level_]; }
  /// For a frame that stays: nothing moves, so that it may take longer.
  Detail still() const;

  /// How long the last frame took, in seconds.
  void update(double frameSeconds);

 private:
  double cost(const Detail& detail) const;
  std::vector<Detail> listLevels() const;
  void restart();
  void change(std::size_t level);
  std::size_t finestWithin(double seconds) const;

  GridShape shape_{};
  bool isFrame_ = false;
  std::optional<StrutStyle> style_;
  std::vector<Detail> levels_;  ///< From the finest to the coarsest, at least one.
  std::size_t level_ = 0;
  double average_ = 0;   ///< Mean time of the frames at this level, in seconds.
  int frames_ = 0;       ///< At this level.
  double slowness_ = 1;  ///< What frames take over what they are expected to, of late.
};

}  // namespace morphgrid
