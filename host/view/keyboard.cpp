#include "view/keyboard.h"

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>

#include <cmath>
#include <utility>

namespace morphgrid {
namespace {

constexpr double kTurnPerPixel = 0.008;  // Radians.
constexpr double kTurnPerKey = 0.06;
constexpr double kZoomPerStep = 0.88;
constexpr float kClickReach = 3;  // Pixels that the mouse may move in a click.

const View kAlongY{{0, 1, 0}, {0, 0, 1}};

bool pressed(int key) { return ImGui::IsKeyPressed(key, false); }

void handleControlKeys(const Snapshot& snapshot, Session& session, const WindowActions& actions,
                       Window& window) {
  if (pressed(GLFW_KEY_Z)) {
    const bool redoes = ImGui::GetIO().KeyShift;
    if (redoes && snapshot.canRedo) session.redo();
    if (!redoes && snapshot.canUndo) session.undo();
  }
  if (pressed(GLFW_KEY_S)) session.saveScene();
  if (pressed(GLFW_KEY_E)) session.exportFiles();
  if (pressed(GLFW_KEY_P)) actions.savePicture();
  if (pressed(GLFW_KEY_R)) session.reload();
  if (pressed(GLFW_KEY_Q)) window.close();
}

void handleStageKeys(const Snapshot& snapshot, ViewState& state) {
  if (pressed(GLFW_KEY_0)) {
    state.stage.reset();
  }
  for (std::size_t n = 0; n < kStageNames.size(); ++n) {
    const auto stage = static_cast<ShownStage>(n);
    if (pressed(GLFW_KEY_1 + static_cast<int>(n)) && snapshot.has(stage)) {
      state.stage = stage;
    }
  }
}

void handlePlainKeys(const Snapshot& snapshot, ViewState& state, Session& session,
                     const WindowActions& actions) {
  handleStageKeys(snapshot, state);
  if (pressed(GLFW_KEY_C)) {
    const auto next = static_cast<std::size_t>(state.coloring) + 1;
    state.coloring = static_cast<Coloring>(next % kColoringNames.size());
  }
  if (pressed(GLFW_KEY_SPACE)) {
    state.isPaused = !state.isPaused;
    session.pause(state.isPaused);
  }
  if (pressed(GLFW_KEY_N)) {
    state.isPaused = true;
    session.step();
  }
  if (pressed(GLFW_KEY_R)) session.restart();
  if (pressed(GLFW_KEY_F)) actions.frameAll();
  if (pressed(GLFW_KEY_T)) state.showsTarget = !state.showsTarget;
  if (pressed(GLFW_KEY_TAB)) state.showsPanels = !state.showsPanels;
  if (pressed(GLFW_KEY_H)) state.showsHelp = !state.showsHelp;
}

void lookFrom(OrbitCamera& camera, const Eigen::AlignedBox3d& extent, const View& view,
              const SceneArea& area) {
  const View alongX{{1, 0, 0}, view.up};
  const std::array<std::pair<int, const View*>, 4> keys = {{{GLFW_KEY_O, &view},
                                                            {GLFW_KEY_X, &alongX},
                                                            {GLFW_KEY_Y, &kAlongY},
                                                            {GLFW_KEY_Z, &kTopView}}};
  for (const auto& [key, look] : keys) {
    if (pressed(key)) {
      camera.frame(extent, *look, area.aspect());
    }
  }
}

void turnByKeys(OrbitCamera& camera) {
  const auto held = [](int key) { return ImGui::IsKeyPressed(key, true) ? 1 : 0; };
  const int right = held(GLFW_KEY_RIGHT) - held(GLFW_KEY_LEFT);
  const int down = held(GLFW_KEY_DOWN) - held(GLFW_KEY_UP);
  const int nearer = held(GLFW_KEY_EQUAL) + held(GLFW_KEY_KP_ADD) - held(GLFW_KEY_MINUS) -
                     held(GLFW_KEY_KP_SUBTRACT);
  if (right != 0 || down != 0) camera.turn(kTurnPerKey * right, kTurnPerKey * down);
  if (nearer != 0) camera.zoom(std::pow(kZoomPerStep, nearer));
}

}  // namespace

void handleKeys(const Snapshot& snapshot, ViewState& state, Session& session,
                const WindowActions& actions, Window& window) {
  const ImGuiIO& io = ImGui::GetIO();
  if (io.WantTextInput) {
    return;
  }
  if (io.KeyCtrl) {
    handleControlKeys(snapshot, session, actions, window);
  } else {
    handlePlainKeys(snapshot, state, session, actions);
  }
}

std::optional<glm::dvec2> handleCamera(OrbitCamera& camera, const Eigen::AlignedBox3d& extent,
                                       const View& view, const SceneArea& area) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!io.WantTextInput && !io.KeyCtrl) {
    lookFrom(camera, extent, view, area);
    turnByKeys(camera);
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
