#include "grid/strain.h"

#include <cassert>

namespace morphgrid {

double strainAt(const StrutGrid& grid, const Eigen::Matrix3Xd& positions, const Strut& strut) {
  const double rest = valueAt(grid.rest, strut);
  return (lengthAt(positions, strut) - rest) / rest;
}

std::vector<double> strains(const StrutGrid& grid, const Eigen::Matrix3Xd& positions) {
  assert(positions.cols() == grid.shape.vertexCount());
  std::vector<double> result;
  result.reserve(grid.shape.strutCount());
  forEachStrut(grid.shape,
               [&](const Strut& strut) { result.push_back(strainAt(grid, positions, strut)); });
  return result;
}

}  // namespace morphgrid
