#include "tests/surface/sample_meshes.h"

#include <cmath>
#include <numbers>

namespace morphgrid {
namespace {

using std::numbers::pi;

/// (columns + 1) x (rows + 1) vertices, in pairs of triangles.
TriangleMesh gridMesh(int columns, int rows,
                      const std::function<Eigen::Vector3d(int, int)>& vertex) {
  TriangleMesh mesh{Eigen::Matrix3Xd(3, (columns + 1) * (rows + 1)),
                    Eigen::Matrix3Xi(3, 2 * columns * rows)};
  const auto index = [=](int i, int j) { return j * (columns + 1) + i; };
  for (int j = 0; j <= rows; ++j) {
    for (int i = 0; i <= columns; ++i) {
      mesh.vertices.col(index(i, j)) = vertex(i, j);
    }
  }
  for (int j = 0; j < rows; ++j) {
    for (int i = 0; i < columns; ++i) {
      const int cell = 2 * (j * columns + i);
      mesh.triangles.col(cell) << index(i, j), index(i + 1, j), index(i + 1, j + 1);
      mesh.triangles.col(cell + 1) << index(i, j), index(i + 1, j + 1), index(i, j + 1);
    }
  }
  return mesh;
}

}  // namespace

TriangleMesh heightField(const SamplingBox& box, int cellsU, int cellsV,
                         const std::function<double(double, double)>& height) {
  return gridMesh(cellsU, cellsV, [&](int i, int j) {
    const double y = box.uStart + box.uLength * (double(i) / cellsU);
    const double z = box.vStart + box.vLength * (double(j) / cellsV);
    return Eigen::Vector3d(height(y, z), y, z);
  });
}

TriangleMesh sphere(double radius, int meridians, int parallels) {
  return gridMesh(meridians, parallels, [=](int i, int j) {
    const double longitude = 2 * pi * (i % meridians) / meridians;
    const double polar = pi * j / parallels;
    const double across = j % parallels == 0 ? 0 : radius * std::sin(polar);
    return Eigen::Vector3d(-radius * std::cos(polar), across * std::cos(longitude),
                           across * std::sin(longitude));
  });
}

TriangleMesh pyramidFan(int sides, double height) {
  TriangleMesh mesh{Eigen::Matrix3Xd::Zero(3, sides + 1), Eigen::Matrix3Xi(3, sides)};
  for (int n = 0; n < sides; ++n) {
    const double angle = 2 * pi * n / sides;
    mesh.vertices.col(n + 1) << height, std::cos(angle), std::sin(angle);
    mesh.triangles.col(n) << 0, n + 1, (n + 1) % sides + 1;
  }
  return mesh;
}

TriangleMesh joined(const TriangleMesh& first, const TriangleMesh& second) {
  TriangleMesh mesh{Eigen::Matrix3Xd(3, first.vertices.cols() + second.vertices.cols()),
                    Eigen::Matrix3Xi(3, first.triangles.cols() + second.triangles.cols())};
  mesh.vertices << first.vertices, second.vertices;
  mesh.triangles << first.triangles,
      (second.triangles.array() + int(first.vertices.cols())).matrix();
  return mesh;
}

}  // namespace morphgrid
