#pragma once
#include <optional>

#include "view/coloring.h"

namespace morphgrid {

/// What the user has chosen to see.
struct ViewState {
  std::optional<ShownStage> stage;  ///< None: what the run has reached.
  Coloring coloring = Coloring::strain;
  bool showsTarget = true;  ///< Translucent, over the result.
  bool showsPanels = true;
  bool showsHelp = false;
  bool isPaused = false;
  bool showsEveryStep = true;
  std::optional<Strut> picked;
};

/// What is shown of a snapshot: the chosen stage where there is one by now.
inline ShownStage stageOf(const ViewState& state, const Snapshot& snapshot) {
  return state.stage && snapshot.has(*state.stage) ? *state.stage : snapshot.newest;
}

inline const std::optional<ShownGrid>& gridOf(ShownStage stage, const Snapshot& snapshot) {
  return snapshot.stages[static_cast<std::size_t>(stage)];
}

/// Not struts.
inline bool looksLikeSurface(ShownStage stage) {
  return stage == ShownStage::target || stage == ShownStage::sampling ||
         stage == ShownStage::surface;
}

}  // namespace morphgrid
