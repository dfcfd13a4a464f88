#include "solve/loaded_rest.h"

namespace morphgrid {

StrutValues loadedRest(const StrutGrid& grid, double share) {
  StrutValues rest = grid.rest;
  if (share < 1) {
    for (const Strut& strut : listStruts(grid.shape)) {
      const double initial = (grid.positions.col(strut.to) - grid.positions.col(strut.from)).norm();
      valueAt(rest, strut) = initial + share * (valueAt(grid.rest, strut) - initial);
    }
  }
  return rest;
}

}  // namespace morphgrid
