#include "surface/triangle_mesh.h"

namespace morphgrid {

Eigen::AlignedBox3d boundingBox(const TriangleMesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const int vertex : mesh.triangles.reshaped()) {
    box.extend(mesh.vertices.col(vertex));
  }
  return box;
}

TriangleMesh transformed(const Eigen::Affine3d& worldFromMesh, TriangleMesh mesh) {
  mesh.vertices = worldFromMesh * mesh.vertices;
  return mesh;
}

}  // namespace morphgrid
