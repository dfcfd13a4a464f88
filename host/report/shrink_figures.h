#pragma once
#include <string>
#include <vector>

#include "grid/strut_grid.h"

namespace morphgrid {

/// How much lateral struts have to shrink (computeShrinks()).
struct ShrinkCounts {
  double largestPercent = 0;
  int strutsOverLimit = 0;  ///< Struts that shrink by more than the material can.
  int strutsAtLimit = 0;    ///< Struts that shrink by as much as it can: there the limit binds.
  int strutsGrowing = 0;    ///< Struts that would have to grow, which no shrinking material does.
  double largestGrowthPercent = 0;
};

/// Counts for the whole grid, and for each layer from the bottom up.
struct ShrinkFigures : ShrinkCounts {
  std::vector<ShrinkCounts> layers;
};

/// maxShrinkage: share of its printed length that a strut can lose. Struts count as over it, at it
/// or growing beyond a millionth of the printed length.
ShrinkFigures computeShrink(const StrutGrid& stacked, double maxShrinkage);

/// What the material cannot do and what to do about it, a sentence each; none where it can.
std::vector<std::string> adviseOn(const ShrinkFigures& shrink, double maxShrinkage);

}  // namespace morphgrid
