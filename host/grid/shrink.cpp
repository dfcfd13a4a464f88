#include "grid/shrink.h"

namespace morphgrid {

StrutValues computeShrinks(const StrutGrid& grid) {
  StrutValues shrinks(grid.shape);
  for (const Strut& strut : listStruts(grid.shape)) {
    const double printed = (grid.positions.col(strut.to) - grid.positions.col(strut.from)).norm();
    valueAt(shrinks, strut) = 1 - valueAt(grid.rest, strut) / printed;
  }
  return shrinks;
}

}  // namespace morphgrid
