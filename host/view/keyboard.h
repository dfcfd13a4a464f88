#pragma once
#include "view/orbit_camera.h"
#include "view/panels.h"
#include "view/scene_view.h"
#include "view/window.h"

namespace morphgrid {

/// What keys and the mouse do, by ImGui: within UserInterface::build().

void handleKeys(const Snapshot& snapshot, ViewState& state, Session& session,
                const WindowActions& actions, Window& window);

/// Turns, moves and zooms the camera by mouse and keys. Returns the pixel of a click, if there
/// was one.
std::optional<glm::dvec2> handleCamera(const Window& window, OrbitCamera& camera,
                                       const Eigen::AlignedBox3d& extent, const View& view,
                                       const SceneArea& area);

}  // namespace morphgrid
