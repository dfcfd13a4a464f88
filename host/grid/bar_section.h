#pragma once
#include <Eigen/Core>
#include <cmath>

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

/// The side of a solid rectangle, in the plane in which it bends, from its EA and EI.
inline double rectangleSide(double stretching, double bending) {
  return std::sqrt(12 * bending / stretching);
}

/// Width and height of the solid rectangle that stretches and bends as the section does, in the
/// scene's unit of length.
inline Eigen::Array2d rectangleOf(const BarSection& section) {
  return {rectangleSide(section.stretching, section.bendingN),
          rectangleSide(section.stretching, section.bendingB)};
}

}  // namespace morphgrid
