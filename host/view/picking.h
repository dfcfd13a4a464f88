#pragma once
#include <optional>

#include "grid/strut_grid.h"
#include "render/camera.h"
#include "view/scene_view.h"

namespace morphgrid {

/// Where a point of the world appears, in pixels of the window; nothing behind the eye.
std::optional<glm::dvec2> pixelOf(const Eigen::Vector3d& point, const glm::dmat4& clipFromWorld,
                                  const SceneArea& area);

/// The strut next to the eye among those that are drawn within `reach` pixels of `pixel`.
/// positions: 3 x vertexCount, in world coordinates.
std::optional<Strut> pickStrut(const GridShape& shape, const Eigen::Matrix3Xd& positions,
                               const glm::dmat4& clipFromWorld, const SceneArea& area,
                               const glm::dvec2& pixel, double reach);

}  // namespace morphgrid
