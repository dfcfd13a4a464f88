#pragma once
#include "grid/strut_grid.h"

namespace morphgrid {

/// What share of its printed length a material can make a strut lose; below 0 it grows.
struct ShrinkRange {
  double least = 0;
  double most = 0.4;  ///< Above `least`, below 1.

  bool operator==(const ShrinkRange&) const = default;
};

/// What share of its printed length each strut has to lose: 1 - L / printed, the printed length
/// being that of grid.positions, where the stage starts. Below 0 where it would have to grow.
StrutValues computeShrinks(const StrutGrid& grid);

}  // namespace morphgrid
