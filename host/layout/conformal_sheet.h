#pragma once
#include <Eigen/Core>

#include "core/cancellation.h"
#include "layout/sheet_problem.h"

namespace morphgrid {

/// How a net lies flat.
struct Sheet {
  Eigen::Matrix2Xd positions;  ///< 2 x layerVertexCount, of the joints; the scene's unit.
  int iterations = 0;          ///< Of Gauss-Newton, on the finest net.
  double seconds = 0;
};

/// Lays a net out flat so that its joints, welded at the angles at which they are printed, have the
/// angles of the target, and every bar of every layer is within the material's range:
///
///     E = sum over bars of mean / (2 L) ((a - b)^2 + 3 (a + b)^2) + 30 log^2(l / nearest)
///
/// a = arg(from -> to) - directionFrom - turn(from), b alike at the other end: the angles by which
/// the joints, when the grid lies on the target, turn the bar's ends in the tangent plane; so the
/// first sum is the bars' own bending and shear there. l is the printed length, `nearest` the
/// nearest that the material allows. Angles fixed and lengths free, the sheet is conformal: its
/// scale varies as little as it can, with a free boundary (Sawhney and Crane 2017, Boundary first
/// flattening). Gauss-Newton on positions and turns, which folds no cell.
///
/// Large nets are laid out from coarser ones on. Throws InputError where the sheet overlaps itself,
/// Cancelled where that is requested.
Sheet layConformally(const SheetProblem& problem, const Cancellation& cancellation = {});

}  // namespace morphgrid
