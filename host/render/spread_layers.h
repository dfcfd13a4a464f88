#pragma once
#include "grid/strut_grid.h"

namespace morphgrid {

/// The layers of a stacked grid side by side in its plane, from the left to the right and from the
/// top to the bottom, the bottom layer first: in as many columns as make them largest in a picture
/// seen from above. aspect = width / height of the picture, > 0.
StrutGrid spreadLayers(const StrutGrid& stacked, double aspect);

}  // namespace morphgrid
