#pragma once
#include <functional>
#include <glm/glm.hpp>
#include <string>
#include <vector>

namespace morphgrid {

/// A mark below a colour bar, at this share of its width.
struct LegendMark {
  double place;
  std::string text;
  std::string secondLine;
};

/// A colour bar with marks.
struct Legend {
  std::string title;
  std::function<glm::vec3(double place)> colorAt;  ///< 0 <= place <= 1 along the bar.
  std::vector<LegendMark> marks;
};

/// Of struts by strain.
Legend strainLegend();

/// Of struts by the share that they use of what they can shrink; beyond its ends the colours of
/// those that would have to grow, and of those over the limit.
Legend shrinkLegend();

/// Of a surface by its distance from 0 to `largest`, in the scene's unit, which is `largestPercent`
/// of the target's diagonal.
Legend distanceLegend(double largest, double largestPercent);

}  // namespace morphgrid
