#include "view/picking.h"

#include <algorithm>
#include <limits>

namespace morphgrid {
namespace {

/// A vertex on the screen.
struct Projected {
  glm::dvec2 pixel;
  double depth;  ///< Along the view, from the eye; <= 0: behind it.
};

Projected project(const Eigen::Vector3d& point, const glm::dmat4& clipFromWorld,
                  const SceneArea& area) {
  const glm::dvec4 clip = clipFromWorld * glm::dvec4(point.x(), point.y(), point.z(), 1);
  if (clip.w <= 0) {
    return {{}, clip.w};
  }
  return {{area.left + area.width * (0.5 + 0.5 * clip.x / clip.w),
           area.top + area.height * (0.5 + 0.5 * clip.y / clip.w)},
          clip.w};
}

/// Where on the segment from a (0) to b (1) the pixel is nearest.
double nearestShare(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& pixel) {
  const glm::dvec2 arm = b - a;
  const double square = glm::dot(arm, arm);
  return square > 0 ? std::clamp(glm::dot(pixel - a, arm) / square, 0.0, 1.0) : 0;
}

}  // namespace

std::optional<glm::dvec2> pixelOf(const Eigen::Vector3d& point, const glm::dmat4& clipFromWorld,
                                  const SceneArea& area) {
  const Projected at = project(point, clipFromWorld, area);
  return at.depth > 0 ? std::optional(at.pixel) : std::nullopt;
}

std::optional<Strut> pickStrut(const GridShape& shape, const Eigen::Matrix3Xd& positions,
                               const glm::dmat4& clipFromWorld, const SceneArea& area,
                               const glm::dvec2& pixel, double reach) {
  std::vector<Projected> vertices(static_cast<std::size_t>(shape.vertexCount()));
  for (Eigen::Index n = 0; n < positions.cols(); ++n) {
    vertices[n] = project(positions.col(n), clipFromWorld, area);
  }
  std::optional<Strut> picked;
  double nearest = std::numeric_limits<double>::infinity();
  forEachStrut(shape, [&](const Strut& strut) {
    const Projected& a = vertices[strut.from];
    const Projected& b = vertices[strut.to];
    if (a.depth <= 0 || b.depth <= 0) {
      return;
    }
    const double share = nearestShare(a.pixel, b.pixel, pixel);
    const double depth = glm::mix(a.depth, b.depth, share);
    if (depth < nearest && glm::distance(glm::mix(a.pixel, b.pixel, share), pixel) <= reach) {
      nearest = depth;
      picked = strut;
    }
  });
  return picked;
}

}  // namespace morphgrid
