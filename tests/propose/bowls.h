#pragma once
#include <fmt/format.h>

#include <functional>
#include <string>

#include "surface/triangle_mesh.h"

namespace morphgrid {

/// z = height(x, y) over [-1, 1]^2 in cells^2 pairs of triangles, facing +z.
inline TriangleMesh heights(int cells, const std::function<double(double, double)>& height) {
  TriangleMesh mesh{Eigen::Matrix3Xd(3, (cells + 1) * (cells + 1)),
                    Eigen::Matrix3Xi(3, 2 * cells * cells)};
  const auto place = [&](int n) { return 2.0 * n / cells - 1; };
  const auto vertex = [&](int i, int j) { return j * (cells + 1) + i; };
  int next = 0;
  for (int j = 0; j <= cells; ++j) {
    for (int i = 0; i <= cells; ++i) {
      mesh.vertices.col(vertex(i, j)) << place(i), place(j), height(place(i), place(j));
      if (i == cells || j == cells) continue;
      mesh.triangles.col(next++) << vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1);
      mesh.triangles.col(next++) << vertex(i, j), vertex(i + 1, j + 1), vertex(i, j + 1);
    }
  }
  return mesh;
}

inline TriangleMesh bowl(int cells = 40) {
  return heights(cells, [](double x, double y) { return 0.3 * (x * x + y * y); });
}

inline TriangleMesh turned(const Eigen::Quaterniond& rotation, const TriangleMesh& mesh) {
  return transformed(Eigen::Affine3d(rotation), mesh);
}

inline std::string toObj(const TriangleMesh& mesh) {
  std::string obj;
  for (const auto& v : mesh.vertices.colwise())
    obj += fmt::format("v {} {} {}\n", v.x(), v.y(), v.z());
  for (const auto& t : mesh.triangles.colwise()) {
    obj += fmt::format("f {} {} {}\n", t.x() + 1, t.y() + 1, t.z() + 1);
  }
  return obj;
}

}  // namespace morphgrid
