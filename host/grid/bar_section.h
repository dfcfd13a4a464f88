#pragma once
#include "grid/bars.h"

namespace morphgrid {

/// The cross-section of a bar and what it is made of.
struct BarSize {
  double width;            ///< In the sheet's plane as printed, > 0; the scene's unit of length.
  double height;           ///< Across, > 0
  double poisson = 0.3;    ///< >= 0 and < 0.5
  double joint = 0;        ///< See BarSection::joint.
  bool isShearing = true;  ///< Timoshenko's beam, else Euler and Bernoulli's.
};

/// A solid rectangle's stiffnesses: torsion by Roark's formula, a shear correction of 5/6.
/// modulus: Young's, see BarSection for its unit.
BarSection rectangularSection(const BarSize& size, double modulus);

}  // namespace morphgrid
