#pragma once
#include <functional>

#include "grid/shrink.h"

namespace morphgrid {

/// What struts can lose when the flat sheet is printed `scale` times as large as it is; its lengths
/// are those of the sheet so enlarged.
using BoundsAtScale = std::function<ShrinkBounds(double scale)>;

/// How many times as large the flat sheet should be printed as stacked.positions have it, so that
/// its struts have equal room to shrink less and to shrink more: the rest lengths' shares of the
/// printed lengths then lie, on a scale of ratios, in the middle of what each strut can do.
double choosePrintScale(const StrutGrid& stacked, const BoundsAtScale& boundsAt);

}  // namespace morphgrid
