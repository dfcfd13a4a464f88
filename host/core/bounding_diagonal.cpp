#include "core/bounding_diagonal.h"

namespace morphgrid {

double boundingDiagonal(const Eigen::Matrix3Xd& points) {
  return (points.rowwise().maxCoeff() - points.rowwise().minCoeff()).norm();
}

}  // namespace morphgrid
