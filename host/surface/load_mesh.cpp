#include "surface/load_mesh.h"

#include <fmt/format.h>

#include <algorithm>

#include "surface/mesh_formats.h"

namespace morphgrid {
namespace {

struct Format {
  std::string_view extension;
  NotedMesh (*read)(const MeshSource&);
};

const Format kFormats[] = {{".obj", readObj},
                           {".stl", readStl},
                           {".ply", readPly},
                           {".gltf", readGltf},
                           {".glb", readGltf}};

/// Null: none.
const Format* findFormat(const std::filesystem::path& file) {
  const std::string extension = file.extension().string();
  const auto* const format = std::ranges::find_if(
      kFormats, [&](const Format& known) { return isSameWithoutCase(extension, known.extension); });
  return format == std::end(kFormats) ? nullptr : format;
}

/// Vertices that no triangle uses are often no numbers: what a scanner did not see, for one.
TriangleMesh withoutUnusedVertices(const TriangleMesh& mesh) {
  std::vector<int> newIndices(mesh.vertices.cols(), -1);
  std::vector<int> used;
  TriangleMesh result{{}, mesh.triangles};
  for (int& corner : result.triangles.reshaped()) {
    int& index = newIndices[corner];
    if (index < 0) {
      index = static_cast<int>(used.size());
      used.push_back(corner);
    }
    corner = index;
  }
  result.vertices = mesh.vertices(Eigen::all, used);
  return result;
}

void requireTriangles(const MeshSource& source, const TriangleMesh& mesh) {
  if (mesh.triangles.cols() > 0) return;
  if (mesh.vertices.cols() == 0) throw source.error("holds no triangle");
  throw pointCloudError(source, mesh.vertices.cols());
}

void requireFiniteCorners(const MeshSource& source, const TriangleMesh& mesh) {
  for (const int corner : mesh.triangles.reshaped()) {
    const Eigen::Vector3d vertex = mesh.vertices.col(corner);
    if (vertex.allFinite()) continue;
    throw source.error(fmt::format("vertex {}: coordinates must be finite, got {}, {}, {}", corner,
                                   vertex.x(), vertex.y(), vertex.z()));
  }
}

}  // namespace

NotedMesh readMesh(const MeshSource& source) {
  const Format* format = findFormat(source.file);
  if (!format) {
    throw source.error(fmt::format("the extension must be .obj, .stl, .ply, .gltf or .glb, got {}",
                                   inQuotes(source.file.extension().string())));
  }
  if (source.bytes.empty()) throw source.error("is empty");
  NotedMesh noted = format->read(source);
  requireTriangles(source, noted.mesh);
  if (!noted.mesh.vertices.allFinite()) {
    requireFiniteCorners(source, noted.mesh);
    noted.mesh = withoutUnusedVertices(noted.mesh);
  }
  return noted;
}

NotedMesh loadMesh(const std::filesystem::path& file) {
  const std::string bytes = readMeshFile(file);
  return readMesh({file, bytes});
}

bool isMeshName(const std::filesystem::path& file) { return findFormat(file) != nullptr; }

}  // namespace morphgrid
