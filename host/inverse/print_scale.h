#pragma once
#include "grid/strut_grid.h"

namespace morphgrid {

/// How many times as large the flat sheet should be printed as stacked.positions have it, so that
/// its struts have equal room to shrink less and to shrink more: the rest lengths' shares of the
/// printed lengths then lie, on a scale of ratios, around the middle of [1 - maxShrinkage, 1].
/// maxShrinkage: share of its printed length that a strut can lose, in (0, 1).
double choosePrintScale(const StrutGrid& stacked, double maxShrinkage);

}  // namespace morphgrid
