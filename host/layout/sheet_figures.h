#pragma once
#include <string>
#include <vector>

#include "layout/conformal_sheet.h"

namespace morphgrid {

/// How well a flat sheet fits its target.
struct SheetFigures {
  /// Printed angle of a joint's corner less that in the target's tangent plane, rad.
  double meanAngle = 0;
  double largestAngle = 0;
  /// Largest over smallest chord of the target over its printed length.
  double scaleRatio = 1;
  int lateralStruts = 0;     ///< Of all layers.
  int strutsOutOfRange = 0;  ///< Of them, those that would shrink by more or less than they can.
  int barsBeyondRange = 0;  ///< Struts of the net whose layers alone differ by more than the range.
  /// Angle of a joint's corner in the top layer less that in the bottom one, rad: what welded
  /// joints, printed alike in all layers, resist.
  double meanTwist = 0;
  double largestTwist = 0;
  double sizeX = 0, sizeY = 0;  ///< Of the sheet, in the scene's unit.
  /// The layer spacing at which 99 % of the net's struts would fit by themselves.
  double fittingLayerSpacing = 0;
  int iterations = 0;
  double seconds = 0;
};

/// layerSpacing: of neighbouring layers, > 0.
SheetFigures computeSheetFigures(const SheetProblem& problem, const Sheet& sheet,
                                 double layerSpacing);

/// Of each joint, the largest of its corners' printed angles less those in the target's tangent
/// plane, absolute, rad; layerVertexCount.
Eigen::VectorXd printedAngleErrors(const SheetProblem& problem, const Sheet& sheet);

/// What to change where more than 1 % of the struts do not fit the material; a sentence each.
std::vector<std::string> adviseOn(const SheetFigures& sheet, const ShrinkBounds& shrink);

}  // namespace morphgrid
