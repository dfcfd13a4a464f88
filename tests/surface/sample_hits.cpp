#include "tests/surface/sample_hits.h"

#include <algorithm>
#include <cmath>

namespace morphgrid {

RayHits sampleHits(const SamplingBox& box, int countU, int countV,
                   const std::function<double(double, double)>& x) {
  RayHits hits{box, countU, countV, Eigen::Matrix3Xd(3, countU * countV), {}};
  for (int j = 0; j < countV; ++j) {
    for (int i = 0; i < countU; ++i) {
      const double height = x(hits.u(i), hits.v(j));
      hits.hit.push_back(!std::isnan(height));
      hits.points.col(hits.index(i, j)) << (std::isnan(height) ? 0 : height), hits.u(i), hits.v(j);
    }
  }
  return hits;
}

void punchHole(RayHits& hits, int firstU, int lastU, int firstV, int lastV) {
  for (int j = firstV; j <= lastV; ++j) {
    for (int i = firstU; i <= lastU; ++i) {
      hits.hit[hits.index(i, j)] = 0;
      hits.points(0, hits.index(i, j)) = 0;
    }
  }
}

long countMisses(const RayHits& hits) { return std::count(hits.hit.begin(), hits.hit.end(), 0); }

}  // namespace morphgrid
