#include "grid/shrink.h"

namespace morphgrid {

StrutValues computeShrinks(const StrutGrid& grid) {
  StrutValues shrinks(grid.shape);
  forEachStrut(grid.shape, [&](const Strut& strut) {
    valueAt(shrinks, strut) = 1 - valueAt(grid.rest, strut) / lengthAt(grid.positions, strut);
  });
  return shrinks;
}

StrutValues computeShrinkShares(const StrutGrid& grid, const ShrinkBounds& bounds) {
  StrutValues shares = computeShrinks(grid);
  forEachStrut(grid.shape, [&](const Strut& strut) {
    valueAt(shares, strut) /=
        strut.isLateral() ? bounds.at(lengthAt(grid.positions, strut)).most : bounds.material.most;
  });
  return shares;
}

}  // namespace morphgrid
