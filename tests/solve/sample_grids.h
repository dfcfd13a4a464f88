#pragma once
#include "grid/strut_grid.h"

namespace morphgrid {

/// A flat grid with unit cells, layers 0.3 apart, whose rest lengths differ between layers (it
/// bends) and by a few random percent (no symmetry). Normalised stiffnesses.
StrutGrid bentGrid(const GridShape& shape, unsigned seed);

/// Its corners in a layer rest at angles as printed, of 65 to 115 degrees.
StrutGrid withPrintedCorners(StrutGrid grid);

/// positions with random offsets of up to `amount` in each coordinate.
Eigen::Matrix3Xd shaken(const Eigen::Matrix3Xd& positions, double amount, unsigned seed);

/// A strip along u whose struts all bend by theta: on a circle at rest.
StrutGrid circularStrip(int nodes, int layers, double theta, double layerSpacing);

/// Radius of the circle on which the bottom layer of a circularStrip() of 20 nodes lies.
double stripRadius(const GridShape& shape, const Eigen::Matrix3Xd& positions);

}  // namespace morphgrid
