#include "surface/load_mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

#include "surface/mesh_formats.h"

namespace morphgrid {
namespace {

struct Format {
  const char* extension;
  TriangleMesh (*read)(const MeshSource&);
};

const Format kFormats[] = {{".obj", readObj},
                           {".stl", readStl},
                           {".ply", readPly},
                           {".gltf", readGltf},
                           {".glb", readGltf}};

std::string lowerCase(std::string text) {
  std::ranges::transform(text, text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text;
}

const Format& formatOf(const MeshSource& source) {
  const std::string extension = lowerCase(source.file.extension().string());
  for (const Format& format : kFormats) {
    if (extension == format.extension) return format;
  }
  throw source.error(fmt::format("the extension must be .obj, .stl, .ply, .gltf or .glb, got {}",
                                 inQuotes(source.file.extension().string())));
}

void requireSound(const MeshSource& source, const TriangleMesh& mesh) {
  if (mesh.triangles.cols() == 0) throw source.error("holds no triangle");
  if (mesh.vertices.allFinite()) return;
  for (Eigen::Index i = 0; i < mesh.vertices.cols(); ++i) {
    const Eigen::Vector3d vertex = mesh.vertices.col(i);
    if (vertex.allFinite()) continue;
    throw source.error(fmt::format("vertex {}: coordinates must be finite, got {}, {}, {}", i,
                                   vertex.x(), vertex.y(), vertex.z()));
  }
}

}  // namespace

TriangleMesh readMesh(const MeshSource& source) {
  const Format& format = formatOf(source);
  if (source.bytes.empty()) throw source.error("is empty");
  TriangleMesh mesh = format.read(source);
  requireSound(source, mesh);
  return mesh;
}

TriangleMesh loadMesh(const std::filesystem::path& file) {
  const std::string bytes = readMeshFile(file);
  return readMesh({file, bytes});
}

bool isMeshName(const std::filesystem::path& file) {
  const std::string extension = lowerCase(file.extension().string());
  return std::ranges::any_of(kFormats,
                             [&](const Format& format) { return extension == format.extension; });
}

}  // namespace morphgrid
