#include "export/tube_mesh.h"

#include <Eigen/Geometry>
#include <numbers>

#include "export/repeat_triangles.h"

namespace morphgrid {
namespace {

using Eigen::Vector3d;
using Hexagon = Eigen::Matrix<double, 3, kTubeMeshSides>;

/// Of radius 1, counter-clockwise about the axis.
Hexagon hexagonAbout(const Vector3d& axis) {
  const Vector3d side = axis.unitOrthogonal();
  const Vector3d other = axis.cross(side);
  Hexagon corners;
  for (int n = 0; n < kTubeMeshSides; ++n) {
    const double angle = 2 * std::numbers::pi * n / kTubeMeshSides;
    corners.col(n) = std::cos(angle) * side + std::sin(angle) * other;
  }
  return corners;
}

/// A strut that has shrunk to nothing has no direction, and keeps that in which it was printed.
Hexagon hexagonOf(const Vector3d& printed, const Vector3d& now) {
  const Vector3d axis = printed.normalized();
  const Vector3d to = now.isZero(0) ? axis : now;
  return Eigen::Quaterniond::FromTwoVectors(axis, to).matrix() * hexagonAbout(axis);
}

/// Of a tube whose vertices begin at 0: its sides, then both ends.
Eigen::Matrix3Xi trianglesOfTube() {
  constexpr int kSides = kTubeMeshSides;
  Eigen::Matrix3Xi triangles(3, kTubeMeshTriangles);
  Eigen::Index next = 0;
  for (int n = 0; n < kSides; ++n) {
    const int side = (n + 1) % kSides;
    triangles.col(next++) << n, side, kSides + side;
    triangles.col(next++) << n, kSides + side, kSides + n;
  }
  for (int n = 1; n + 1 < kSides; ++n) {
    triangles.col(next++) << 0, n + 1, n;
    triangles.col(next++) << kSides, kSides + n, kSides + n + 1;
  }
  return triangles;
}

}  // namespace

Eigen::Matrix3Xd tubeVertices(const StrutGrid& grid, const Eigen::Matrix3Xd& positions) {
  Eigen::Matrix3Xd vertices(3, kTubeMeshVertices * Eigen::Index{grid.shape.strutCount()});
  Eigen::Index next = 0;
  forEachStrut(grid.shape, [&](const Strut& strut) {
    const Hexagon around = kTubeRadius * grid.spacing *
                           hexagonOf(grid.positions.col(strut.to) - grid.positions.col(strut.from),
                                     positions.col(strut.to) - positions.col(strut.from));
    for (const int vertex : {strut.from, strut.to}) {
      vertices.middleCols<kTubeMeshSides>(next) = around.colwise() + positions.col(vertex);
      next += kTubeMeshSides;
    }
  });
  return vertices;
}

Eigen::Matrix3Xi tubeTriangles(const GridShape& shape) {
  return repeatTriangles(trianglesOfTube(), kTubeMeshVertices, shape.strutCount());
}

}  // namespace morphgrid
