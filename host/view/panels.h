#pragma once
#include <functional>

#include "view/view_state.h"

namespace morphgrid {

constexpr int kPanelWidth = 436;  ///< Pixels.

/// What panels ask of the window itself.
struct WindowActions {
  std::function<void()> frameAll;
  std::function<void()> savePicture;
};

/// The panels on the left, by ImGui: within UserInterface::build(). What the user does there goes
/// to the state, the session and the actions.
void drawPanels(const Snapshot& snapshot, ViewState& state, Session& session,
                const WindowActions& actions, int windowHeight);

/// The numbers of a strut of a shown grid, which has a StrutGrid and positions.
void drawStrutNumbers(const Snapshot& snapshot, const ShownGrid& shown, const Strut& strut);

void drawHelp(bool& isOpen);

}  // namespace morphgrid
