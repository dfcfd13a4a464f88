#include "grid/shrink.h"

namespace morphgrid {

StrutValues computeShrinks(const StrutGrid& grid) {
  StrutValues shrinks(grid.shape);
  forEachStrut(grid.shape, [&](const Strut& strut) {
    valueAt(shrinks, strut) = 1 - valueAt(grid.rest, strut) / lengthAt(grid.positions, strut);
  });
  return shrinks;
}

}  // namespace morphgrid
