#include "export/gltf.h"

#include "export/gltf_parts.h"
#include "export/gltf_struts.h"

namespace morphgrid {
namespace {

void addSurface(tinygltf::Model& model, const SurfaceMesh& surface, const Eigen::Vector3d& origin) {
  tinygltf::Primitive triangles;
  triangles.attributes["POSITION"] =
      addPositions(model, (surface.vertices.colwise() - origin).cast<float>());
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
  const Eigen::Vector3d origin = middleOf(positions);
  tinygltf::Model model = emptyModel();
  addStrutNode(model, addStruts(model, grid, positions.colwise() - origin, rotations));
  addSurface(model, surface, origin);
  placeAt(model, origin);
  writeModel(path, model);
}

}  // namespace morphgrid
