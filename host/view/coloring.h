#pragma once
#include "render/legend.h"
#include "view/session.h"

namespace morphgrid {

enum class Coloring { strain, shrink, layer, distance, bendingStrain, jointRotation, angleError };
constexpr std::array<const char*, 7> kColoringNames = {"strain",
                                                       "shrink",
                                                       "layer",
                                                       "distance",
                                                       "bending strain",
                                                       "joint rotation",
                                                       "printed angle error"};

/// Numbers for the colours of struts and of the middle layer's surface, and what they mean.
struct ColorShares {
  StrutValues shares;
  Eigen::VectorXd columns;  ///< layerVertexCount; empty where surfaces have none.
  Legend legend;
};

/// What a grid lacks to be coloured so, for people; empty where it lacks nothing. The solver's
/// coarser grids lack all but strains.
std::string whatIsMissing(Coloring coloring, const ShownGrid& shown, const Snapshot& snapshot);

inline bool canColor(Coloring coloring, const ShownGrid& shown, const Snapshot& snapshot) {
  return whatIsMissing(coloring, shown, snapshot).empty();
}

/// Whether the middle layer's surface shows it too.
constexpr bool isOfColumns(Coloring coloring) {
  return coloring == Coloring::distance || coloring == Coloring::angleError;
}

/// Whether it changes while the grid moves.
constexpr bool followsMotion(Coloring coloring) {
  return coloring == Coloring::distance || coloring == Coloring::bendingStrain ||
         coloring == Coloring::jointRotation;
}

/// For all but Coloring::strain, which the shaders compute. canColor() must hold.
/// Shrink: the share of what a strut can lose. Layer: from the bottom to the top. Distance: of a
/// column's middle to its target, from 0 to the largest; of a strut, the mean of its ends'; so is
/// the printed angle error. Bending strain and joint rotation: those of BarState, from 0 to the
/// largest.
ColorShares computeColors(Coloring coloring, const ShownGrid& shown, const Snapshot& snapshot);

}  // namespace morphgrid
