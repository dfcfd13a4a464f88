#include "tests/render/sample_samplings.h"

namespace morphgrid {

TriangleMesh heightMesh(const Heights& heights, double sizeY, double sizeZ, int cellsY,
                        int cellsZ) {
  TriangleMesh mesh;
  mesh.vertices.resize(3, static_cast<Eigen::Index>(cellsY + 1) * (cellsZ + 1));
  mesh.triangles.resize(3, 2 * static_cast<Eigen::Index>(cellsY) * cellsZ);
  const auto index = [&](int i, int j) { return j * (cellsY + 1) + i; };
  for (int j = 0; j <= cellsZ; ++j) {
    for (int i = 0; i <= cellsY; ++i) {
      const double y = sizeY * i / cellsY, z = sizeZ * j / cellsZ;
      mesh.vertices.col(index(i, j)) << heights(y, z), y, z;
    }
  }
  for (int j = 0; j < cellsZ; ++j) {
    for (int i = 0; i < cellsY; ++i) {
      const Eigen::Index cell = static_cast<Eigen::Index>(j) * cellsY + i;
      mesh.triangles.col(2 * cell) << index(i, j), index(i + 1, j), index(i + 1, j + 1);
      mesh.triangles.col(2 * cell + 1) << index(i, j), index(i + 1, j + 1), index(i, j + 1);
    }
  }
  return mesh;
}

RayHits heightHits(const Heights& heights, const SamplingBox& box, int countU, int countV) {
  RayHits hits{box, countU, countV, Eigen::Matrix3Xd(3, static_cast<Eigen::Index>(countU) * countV),
               std::vector<char>(static_cast<std::size_t>(countU) * countV, 1)};
  for (int j = 0; j < countV; ++j) {
    for (int i = 0; i < countU; ++i) {
      const double y = box.uStart + box.uLength * i / (countU - 1);
      const double z = box.vStart + box.vLength * j / (countV - 1);
      hits.points.col(hits.index(i, j)) << heights(y, z), y, z;
    }
  }
  return hits;
}

void miss(RayHits& hits, int i, int j) {
  hits.hit[hits.index(i, j)] = 0;
  hits.points(0, hits.index(i, j)) = 0;
}

TriangleMesh speckAt(const Eigen::Vector3d& point) {
  TriangleMesh mesh;
  mesh.vertices = point.replicate<1, 3>() + 1e-9 * Eigen::Matrix3d::Identity();
  mesh.triangles.resize(3, 1);
  mesh.triangles << 0, 1, 2;
  return mesh;
}

}  // namespace morphgrid
