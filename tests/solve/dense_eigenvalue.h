#pragma once
#include "solve/smallest_eigenvalue.h"

namespace morphgrid {

/// The oracle of computeSmallestEigenvalue(): of the dense exact Hessian at the grid's positions,
/// over the mean stiffness, with rigid motions (in the plane also z) projected out.
double denseSmallestEigenvalue(const StrutGrid& grid, Motions motions);

/// A flat sheet of layers 0.1 apart whose struts shrink by up to the share `shrink` at its rim and
/// not in its middle, alike in all layers: nothing pushes it out of the plane, where it is
/// compressed.
StrutGrid tightRimmedSheet(const GridShape& shape, double shrink = 0.3);

/// The grid where the reference solver brings it to rest.
StrutGrid atRest(StrutGrid grid);

}  // namespace morphgrid
