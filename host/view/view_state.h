#pragma once
#include <optional>

#include "render/grid_painter.h"
#include "view/coloring.h"

namespace morphgrid {

constexpr std::array<const char*, 3> kStrutStyleNames = {"lines", "ribbons", "tubes"};

/// What the user has chosen to see.
struct ViewState {
  std::optional<ShownStage> stage;  ///< None: what the run has reached.
  Coloring coloring = Coloring::strain;
  std::optional<StrutStyle> strutStyle;  ///< None: as fine as frames allow.
  bool showsTarget = true;               ///< Translucent, over the result.
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

/// Whether what is shown is in colours that mean something: struts are, and the result's surface by
/// what its columns have.
inline bool isColored(const ViewState& state, const Snapshot& snapshot) {
  const ShownStage stage = stageOf(state, snapshot);
  const auto& shown = gridOf(stage, snapshot);
  return !looksLikeSurface(stage) || (stage == ShownStage::surface && isOfColumns(state.coloring) &&
                                      shown && canColor(state.coloring, *shown, snapshot));
}

}  // namespace morphgrid
