#pragma once
#include "design/grid_size.h"
#include "surface/bezier_patch.h"

namespace morphgrid {

/// 15 x 15 units of length large; the control points of a regular lattice, moved by up to 1 in the
/// plane and 3 out of it.
BezierPatch randomPatch(unsigned seed);

/// 24 nodes along the longer side, three layers 0.35 spacings apart (or as far as Eq. 21 allows),
/// the default shrinkage.
DesignRequest requestForRandomPatch(const SurfaceSurvey& survey);

}  // namespace morphgrid
