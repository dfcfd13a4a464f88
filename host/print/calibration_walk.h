#pragma once
#include "print/calibration_plate.h"

namespace morphgrid {

/// What is laid at one height of specimens with the same height_step.
struct PlatePass {
  int pass;           ///< From 0.
  double heightStep;  ///< mm, as what follows.
  double height;
  double z;           ///< Of its upper side.
  double ringHeight;  ///< Of the rings that are laid in it; 0: none.
};

/// Passes of all specimens, the lowest first: those with other steps lie between.
std::vector<PlatePass> passesOf(const CalibrationPlate& plate);

}  // namespace morphgrid
