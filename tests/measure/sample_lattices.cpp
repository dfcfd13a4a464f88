#include "tests/measure/sample_lattices.h"

namespace morphgrid {

PointLattice latticeOn(const std::function<Eigen::Vector3d(double, double)>& point, int countU,
                       int countV) {
  PointLattice lattice{countU, countV, Eigen::Matrix3Xd(3, countU * countV)};
  for (int j = 0; j < countV; ++j) {
    for (int i = 0; i < countU; ++i) {
      lattice.points.col(lattice.index(i, j)) =
          point(double(i) / (countU - 1), double(j) / (countV - 1));
    }
  }
  return lattice;
}

}  // namespace morphgrid
