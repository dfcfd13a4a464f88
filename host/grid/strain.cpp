#include "grid/strain.h"

#include <cassert>

namespace morphgrid {

std::vector<double> strains(const StrutGrid& grid, const Eigen::Matrix3Xd& positions) {
  assert(positions.cols() == grid.shape.vertexCount());
  std::vector<double> result;
  result.reserve(grid.shape.strutCount());
  for (const Strut& strut : listStruts(grid.shape)) {
    const double length = (positions.col(strut.to) - positions.col(strut.from)).norm();
    const double rest = valueAt(grid.rest, strut);
    result.push_back((length - rest) / rest);
  }
  return result;
}

}  // namespace morphgrid
