#include "export/gltf.h"

#include "export/gltf_parts.h"

namespace morphgrid {
namespace {

void addSurface(tinygltf::Model& model, const SurfaceMesh& surface) {
  tinygltf::Primitive triangles;
  triangles.attributes["POSITION"] = addPositions(model, surface.vertices.cast<float>());
  triangles.attributes["NORMAL"] = addVectors(model, surface.normals.cast<float>());
  triangles.indices = addIndices(model, surface.triangles);
  addSurfaceNode(model, std::move(triangles));
}

}  // namespace

void exportGltf(const std::filesystem::path& path, const StrutGrid& grid,
                const Eigen::Matrix3Xd& positions, const SurfaceMesh& surface,
                const JointRotations& rotations) {
  requireFloats(path, positions);
  requireFloats(path, surface.vertices);
  tinygltf::Model model = emptyModel();
  addStrutNode(model, addStruts(model, grid, positions, rotations));
  addSurface(model, surface);
  writeModel(path, model);
}

}  // namespace morphgrid
