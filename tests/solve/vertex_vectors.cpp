#include "tests/solve/vertex_vectors.h"

namespace morphgrid {

std::vector<vec4> packVector(const Eigen::VectorXd& values) {
  std::vector<vec4> packed;
  for (Eigen::Index n = 0; n < values.size(); n += 3) {
    packed.emplace_back(values[n], values[n + 1], values[n + 2], 0);
  }
  return packed;
}

Eigen::VectorXd unpackVector(const std::vector<vec4>& packed) {
  Eigen::VectorXd values(3 * packed.size());
  for (std::size_t n = 0; n < packed.size(); ++n) {
    values.segment<3>(static_cast<Eigen::Index>(3 * n)) << packed[n].x, packed[n].y, packed[n].z;
  }
  return values;
}

}  // namespace morphgrid
