#include "view/keyboard.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <cmath>

namespace morphgrid {
namespace {

constexpr double kTurnPerPixel = 0.008;  // Radians.
constexpr double kTurnPerKey = 0.06;
constexpr double kZoomPerStep = 0.88;
constexpr float kClickReach = 3;  // Pixels that the mouse may move in a click.

const View kAlongY{{0, 1, 0}, {0, 0, 1}};

void handleControlKey(const KeyPress& press, const Snapshot& snapshot, Session& session,
                      const WindowActions& actions, Window& window) {
  switch (press.key) {
    case GLFW_KEY_Z:
      if (press.shift && snapshot.canRedo) session.redo();
      if (!press.shift && snapshot.canUndo) session.undo();
      break;
    case GLFW_KEY_S:
      return session.saveScene();
    case GLFW_KEY_E:
      return session.exportFiles();
    case GLFW_KEY_P:
      return actions.savePicture();
    case GLFW_KEY_R:
      return session.reload();
    case GLFW_KEY_Q:
      return window.close();
    default:
      break;
  }
}

void handleStageKey(int key, const Snapshot& snapshot, ViewState& state) {
  if (key == GLFW_KEY_0) {
    state.stage.reset();
  }
  const int n = key - GLFW_KEY_1;
  if (n >= 0 && n < static_cast<int>(kStageNames.size()) &&
      snapshot.has(static_cast<ShownStage>(n))) {
    state.stage = static_cast<ShownStage>(n);
  }
}

/// The next one that the shown grid can have.
void takeNextColoring(const Snapshot& snapshot, ViewState& state) {
  const auto& shown = gridOf(stageOf(state, snapshot), snapshot);
  auto next = static_cast<std::size_t>(state.coloring);
  do {
    next = (next + 1) % kColoringNames.size();
  } while (shown && !canColor(static_cast<Coloring>(next), *shown, snapshot));
  state.coloring = static_cast<Coloring>(next);
}

/// Automatic, then each style.
void takeNextStrutStyle(ViewState& state) {
  const std::size_t next = state.strutStyle ? static_cast<std::size_t>(*state.strutStyle) + 1 : 0;
  state.strutStyle.reset();
  if (next < kStrutStyleNames.size()) {
    state.strutStyle = static_cast<StrutStyle>(next);
  }
}

void handlePlainKey(int key, const Snapshot& snapshot, ViewState& state, Session& session,
                    const WindowActions& actions) {
  handleStageKey(key, snapshot, state);
  switch (key) {
    case GLFW_KEY_C:
      return takeNextColoring(snapshot, state);
    case GLFW_KEY_S:
      return takeNextStrutStyle(state);
    case GLFW_KEY_SPACE:
      state.isPaused = !state.isPaused;
      return session.pause(state.isPaused);
    case GLFW_KEY_N:
      state.isPaused = true;
      return session.step();
    case GLFW_KEY_R:
      return session.restart();
    case GLFW_KEY_F:
      return actions.frameAll();
    case GLFW_KEY_T:
      state.showsTarget = !state.showsTarget;
      break;
    case GLFW_KEY_TAB:
      state.showsPanels = !state.showsPanels;
      break;
    case GLFW_KEY_H:
      state.showsHelp = !state.showsHelp;
      break;
    default:
      break;
  }
}

void moveCamera(int key, OrbitCamera& camera, const Eigen::AlignedBox3d& extent, const View& view,
                const SceneArea& area) {
  switch (key) {
    case GLFW_KEY_O:
      return camera.frame(extent, view, area.aspect());
    case GLFW_KEY_X:
      return camera.frame(extent, {{1, 0, 0}, view.up}, area.aspect());
    case GLFW_KEY_Y:
      return camera.frame(extent, kAlongY, area.aspect());
    case GLFW_KEY_Z:
      return camera.frame(extent, kTopView, area.aspect());
    case GLFW_KEY_RIGHT:
      return camera.turn(kTurnPerKey, 0);
    case GLFW_KEY_LEFT:
      return camera.turn(-kTurnPerKey, 0);
    case GLFW_KEY_DOWN:
      return camera.turn(0, kTurnPerKey);
    case GLFW_KEY_UP:
      return camera.turn(0, -kTurnPerKey);
    case GLFW_KEY_EQUAL:
    case GLFW_KEY_KP_ADD:
      return camera.zoom(kZoomPerStep);
    case GLFW_KEY_MINUS:
    case GLFW_KEY_KP_SUBTRACT:
      return camera.zoom(1 / kZoomPerStep);
    default:
      break;
  }
}

}  // namespace

void handleKeys(const Snapshot& snapshot, ViewState& state, Session& session,
                const WindowActions& actions, Window& window) {
  if (ImGui::GetIO().WantTextInput) {
    return;
  }
  for (const KeyPress& press : window.keys()) {
    if (press.control) {
      handleControlKey(press, snapshot, session, actions, window);
    } else {
      handlePlainKey(press.key, snapshot, state, session, actions);
    }
  }
}

std::optional<glm::dvec2> handleCamera(const Window& window, OrbitCamera& camera,
                                       const Eigen::AlignedBox3d& extent, const View& view,
                                       const SceneArea& area) {
  const ImGuiIO& io = ImGui::GetIO();
  for (const KeyPress& press : window.keys()) {
    if (!io.WantTextInput && !press.control) {
      moveCamera(press.key, camera, extent, view, area);
    }
  }
  if (io.WantCaptureMouse) {
    return std::nullopt;
  }
  const double right = io.MouseDelta.x;
  const double down = io.MouseDelta.y;
  const bool moves = ImGui::IsMouseDown(ImGuiMouseButton_Right) ||
                     ImGui::IsMouseDown(ImGuiMouseButton_Middle) || io.KeyShift;
  if (moves && ImGui::IsAnyMouseDown()) {
    camera.pan(right / area.height, -down / area.height, area.aspect());
  } else if (ImGui::IsMouseDown(ImGuiMouseButton_Left)) {
    camera.turn(kTurnPerPixel * right, kTurnPerPixel * down);
  }
  if (io.MouseWheel != 0) {
    camera.zoom(std::pow(kZoomPerStep, io.MouseWheel));
  }
  const bool clicked = ImGui::IsMouseReleased(ImGuiMouseButton_Left) &&
                       io.MouseDragMaxDistanceSqr[0] < kClickReach * kClickReach;
  return clicked ? std::optional(glm::dvec2(io.MousePos.x, io.MousePos.y)) : std::nullopt;
}

}  // namespace morphgrid
