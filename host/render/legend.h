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

/// For struts coloured by strain.
Legend strainLegend();

/// For struts coloured by the share that they use of what they can shrink; beyond its ends are the
/// colours of those that would have to grow, and of those over the limit.
Legend shrinkLegend();

/// For a surface coloured by its distance from 0 to `largest`, in the scene's unit, which is
/// `largestPercent` of the target's diagonal.
Legend distanceLegend(double largest, double largestPercent);

/// For struts or surfaces coloured from 0 to `largest`; unit: what stands behind the numbers.
Legend scaleLegend(const std::string& title, double largest, const std::string& unit);

}  // namespace morphgrid
