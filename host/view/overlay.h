#pragma once
#include <optional>

#include "render/legend.h"
#include "view/picking.h"

namespace morphgrid {

/// What is written over the scene, by ImGui: within UserInterface::build().

void drawLegend(const Legend& legend, const SceneArea& area);

/// The world's axes as they lie in the picture.
void drawAxes(const Camera& camera, const SceneArea& area);

/// A round length at the distance of `pivot`, in the scene's unit.
void drawScaleBar(const Camera& camera, const Eigen::Vector3d& pivot, const SceneArea& area);

/// A strut that was picked; from and to in world coordinates.
void drawMark(const Camera& camera, const Eigen::Vector3d& from, const Eigen::Vector3d& to,
              const SceneArea& area);

}  // namespace morphgrid
