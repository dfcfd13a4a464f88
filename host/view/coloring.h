#pragma once
#include "render/legend.h"
#include "view/session.h"

namespace morphgrid {

enum class Coloring { strain, shrink, layer, distance };
constexpr std::array<const char*, 4> kColoringNames = {"strain", "shrink", "layer", "distance"};

/// Numbers for the colours of struts and of the middle layer's surface, and what they mean.
struct ColorShares {
  StrutValues shares;
  Eigen::VectorXd columns;  ///< layerVertexCount; empty where surfaces have none.
  Legend legend;
};

/// Whether a grid can be coloured so: the solver's coarser grids and grids without target lack
/// something.
bool canColor(Coloring coloring, const ShownGrid& shown, const Snapshot& snapshot);

/// For all but Coloring::strain, which the shaders compute. canColor() must hold.
/// Shrink: the share of maxShrinkage. Layer: from the bottom to the top. Distance: of a column's
/// middle to its target, from 0 to the largest; of a strut, the mean of its ends'.
ColorShares computeColors(Coloring coloring, const ShownGrid& shown, const Snapshot& snapshot);

}  // namespace morphgrid
