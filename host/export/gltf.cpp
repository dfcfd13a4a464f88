#include "export/gltf.h"

#include "export/gltf_parts.h"

namespace morphgrid {
namespace {

void addStruts(tinygltf::Model& model, const StrutGrid& grid, const Eigen::Matrix3Xd& positions) {
  tinygltf::Primitive lines;
  lines.attributes["POSITION"] = addPositions(model, strutEnds(grid.shape, positions));
  lines.attributes["COLOR_0"] = addVectors(model, strutColors(grid, positions));
  addStrutNode(model, std::move(lines));
}

void addSurface(tinygltf::Model& model, const SurfaceMesh& surface) {
  tinygltf::Primitive triangles;
  triangles.attributes["POSITION"] = addPositions(model, surface.vertices.cast<float>());
  triangles.attributes["NORMAL"] = addVectors(model, surface.normals.cast<float>());
  triangles.indices = addIndices(model, surface.triangles);
  addSurfaceNode(model, std::move(triangles));
}

}  // namespace

void exportGltf(const std::filesystem::path& path, const StrutGrid& grid,
                const Eigen::Matrix3Xd& positions, const SurfaceMesh& surface) {
  requireFloats(path, positions);
  requireFloats(path, surface.vertices);
  tinygltf::Model model = emptyModel();
  addStruts(model, grid, positions);
  addSurface(model, surface);
  writeModel(path, model);
}

}  // namespace morphgrid
