#include "solve/loaded_rest.h"

namespace morphgrid {

StrutValues loadedRest(const StrutGrid& grid, double share) {
  StrutValues rest = grid.rest;
  if (share < 1) {
    forEachStrut(grid.shape, [&](const Strut& strut) {
      const double initial = lengthAt(grid.positions, strut);
      valueAt(rest, strut) = initial + share * (valueAt(grid.rest, strut) - initial);
    });
  }
  return rest;
}

}  // namespace morphgrid
