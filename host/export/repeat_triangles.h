#pragma once
#include <Eigen/Core>

namespace morphgrid {

/// The triangles of `count` solids whose vertices follow each other: 3 x (count one.cols()). one:
/// those of the first, of vertices 0 to vertexCount - 1.
inline Eigen::Matrix3Xi repeatTriangles(const Eigen::Matrix3Xi& one, int vertexCount, int count) {
  Eigen::Matrix3Xi triangles(3, one.cols() * count);
  for (int n = 0; n < count; ++n) {
    triangles.middleCols(one.cols() * n, one.cols()) = one.array() + vertexCount * n;
  }
  return triangles;
}

}  // namespace morphgrid
