#include "propose/coarsen.h"

#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "surface/main_extent.h"

namespace morphgrid {
namespace {

constexpr Eigen::Index kManyTriangles = 60'000;
constexpr double kCube = 1.0 / 200;  // Of the main extent.

using CubePlace =
    std::array<double, 3>;  // Whole numbers; debris may lie farther than an int counts.

}  // namespace

TriangleMesh coarsened(const TriangleMesh& mesh) {
  if (mesh.triangles.cols() <= kManyTriangles) return mesh;
  const Eigen::AlignedBox3d extent = mainExtent(mesh);
  const double cube = kCube * extent.sizes().maxCoeff();
  if (!(cube > 0)) return mesh;
  std::map<CubePlace, int> clusters;
  std::vector<int> clusterOf(mesh.vertices.cols());
  std::vector<Eigen::Vector3d> vertices;
  for (Eigen::Index n = 0; n < mesh.vertices.cols(); ++n) {
    const Eigen::Vector3d place = (mesh.vertices.col(n) - extent.min()) / cube;
    const CubePlace key{std::floor(place.x()), std::floor(place.y()), std::floor(place.z())};
    const auto [cluster, isNew] = clusters.try_emplace(key, static_cast<int>(vertices.size()));
    if (isNew) vertices.emplace_back(mesh.vertices.col(n));
    clusterOf[n] = cluster->second;
  }
  TriangleMesh coarse{Eigen::Matrix3Xd(3, vertices.size()), Eigen::Matrix3Xi(mesh.triangles)};
  for (std::size_t n = 0; n < vertices.size(); ++n) {
    coarse.vertices.col(static_cast<Eigen::Index>(n)) = vertices[n];
  }
  Eigen::Index kept = 0;
  for (const auto& triangle : mesh.triangles.colwise()) {
    const Eigen::Vector3i corners = triangle.unaryExpr([&](int v) { return clusterOf[v]; });
    if (corners[0] == corners[1] || corners[1] == corners[2] || corners[2] == corners[0]) continue;
    coarse.triangles.col(kept++) = corners;
  }
  if (kept == 0) return mesh;
  coarse.triangles.conservativeResize(3, kept);
  return coarse;
}

}  // namespace morphgrid
