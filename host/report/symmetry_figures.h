#pragma once
#include <Eigen/Core>
#include <optional>
#include <string>

#include "grid/grid_topology.h"

namespace morphgrid {

/// A congruent map of a layer onto itself that takes lines of its net to lines.
enum class Symmetry {
  mirrorAcrossU,  ///< Vertex (i, j) to (last - i, j), by a reflection.
  mirrorAcrossV,  ///< (i, j) to (i, last - j), by a reflection.
  halfTurn,       ///< (i, j) to (last - i, last - j), by a rotation.
};

/// "mirror across u", "mirror across v", "half turn".
std::string toString(Symmetry symmetry);

/// How well a result keeps a symmetry of its target: root mean squares, over the vertices, of the
/// distance between the layer and its symmetric twin, in percent of the target's bounding diagonal.
struct SymmetryFigures {
  Symmetry kind;
  double targetPercent;
  double resultPercent;
};

/// Of the target's symmetries the one that the result keeps worst; nothing when the target has
/// none. targets, result: 3 x shape.layerVertexCount(), the middle layer.
std::optional<SymmetryFigures> computeSymmetry(const GridShape& shape,
                                               const Eigen::Matrix3Xd& targets,
                                               const Eigen::Matrix3Xd& result);

}  // namespace morphgrid
