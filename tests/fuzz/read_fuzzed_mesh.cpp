#include "tests/fuzz/read_fuzzed_mesh.h"

#include <algorithm>
#include <cctype>
#include <optional>
#include <stdexcept>
#include <string>

#include "surface/mesh_formats.h"
#include "surface/subdivide_mesh.h"

namespace morphgrid {
namespace {

void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

std::optional<std::filesystem::path> fileOf(unsigned char letter) {
  switch (std::tolower(letter)) {
    case 'o':
      return "fuzzed.obj";
    case 's':
      return "fuzzed.stl";
    case 'p':
      return "fuzzed.ply";
    case 'g':
      return "fuzzed.gltf";
    default:
      return std::nullopt;
  }
}

void requireSound(const TriangleMesh& mesh) {
  require(mesh.triangles.cols() > 0, "no triangle");
  require(mesh.triangles.minCoeff() >= 0, "negative index");
  require(mesh.triangles.maxCoeff() < mesh.vertices.cols(), "index beyond the last vertex");
  require(mesh.vertices.allFinite(), "coordinate not finite");
}

void requireReadable(const std::string& message) {
  require(message.size() < 400, "message too long");
  require(std::ranges::all_of(message, [](char c) { return c >= ' ' && c <= '~'; }),
          "message of more than one printable line");
}

void requireSound(const NotedMesh& noted) {
  requireSound(noted.mesh);
  std::ranges::for_each(noted.notices, requireReadable);
}

/// Errors have no place. Large meshes, of nodes that repeat theirs, take long and show no more.
void subdivideFuzzed(const TriangleMesh& mesh) {
  if (mesh.triangles.cols() > 2000) return;
  try {
    requireSound(subdivideLoop(mesh, 1));
  } catch (const InputError& error) {
    requireReadable(error.what());
  }
}

}  // namespace

void readFuzzedMesh(std::string_view input) {
  const auto file = fileOf(input.empty() ? '\0' : input.front());
  if (!file) return;
  try {
    const NotedMesh noted = readMesh({*file, input.substr(1)});
    requireSound(noted);
    if (std::isupper(static_cast<unsigned char>(input.front()))) subdivideFuzzed(noted.mesh);
  } catch (const InputError& error) {
    // What a broken glTF file calls a buffer file is named alone.
    if (file->extension() == ".gltf") return;
    const std::string_view message = error.what();
    require(message.starts_with(file->stem().string()), "error without the file's name");
    requireReadable(std::string(message));
  }
}

}  // namespace morphgrid
