#include "tests/measure/lattice_hits.h"

namespace morphgrid {

PointLattice hitsOn(const std::function<double(double, double)>& x, const SamplingBox& box,
                    int countU, int countV) {
  PointLattice hits{countU, countV, Eigen::Matrix3Xd(3, countU * countV)};
  for (int j = 0; j < countV; ++j) {
    for (int i = 0; i < countU; ++i) {
      const double y = box.uStart + box.uLength * i / (countU - 1);
      const double z = box.vStart + box.vLength * j / (countV - 1);
      hits.points.col(hits.index(i, j)) << x(y, z), y, z;
    }
  }
  return hits;
}

}  // namespace morphgrid
