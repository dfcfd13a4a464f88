#pragma once
#include <string>

#include "core/array_file.h"
#include "grid/strut_grid.h"

namespace morphgrid {

/// Raise the version when what was written before can no longer be read.
inline constexpr ArrayFormat kStateFormat{"morphgrid state", 1, "state", "run the scene again"};

/// The name of a weight's array.
inline std::string weightArray(const TermWeight& weight) {
  return std::string(weight.name) + "_weight";
}

/// The shapes of a grid's arrays: the layer, then v, then u.
struct StateShapes {
  std::size_t layers, verticesV, verticesU;

  explicit StateShapes(const GridShape& shape)
      : layers(static_cast<std::size_t>(shape.layers)),
        verticesV(static_cast<std::size_t>(shape.verticesV)),
        verticesU(static_cast<std::size_t>(shape.verticesU)) {}

  ArrayShape layerPoints() const { return {verticesV, verticesU, 3}; }
  ArrayShape layerVertices() const { return {verticesV, verticesU}; }
  ArrayShape rotations() const { return {layers, verticesV, verticesU, 4}; }
  ArrayShape points() const { return {layers, verticesV, verticesU, 3}; }
  /// Shapes for the struts of one layer, then for those of all layers.
  ArrayShape layerStrutsU() const { return {verticesV, verticesU - 1}; }
  ArrayShape layerStrutsV() const { return {verticesV - 1, verticesU}; }
  ArrayShape strutsU() const { return {layers, verticesV, verticesU - 1}; }
  ArrayShape strutsV() const { return {layers, verticesV - 1, verticesU}; }
  ArrayShape strutsW() const { return {layers - 1, verticesV, verticesU}; }
};

}  // namespace morphgrid
