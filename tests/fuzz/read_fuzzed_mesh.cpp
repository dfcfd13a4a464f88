#include "tests/fuzz/read_fuzzed_mesh.h"

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <string>

#include "surface/mesh_formats.h"

namespace morphgrid {
namespace {

void require(bool holds, const char* what) {
  if (!holds) throw std::logic_error(what);
}

std::optional<std::filesystem::path> fileOf(char letter) {
  switch (letter) {
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

void requireReadable(const std::string& message, const std::filesystem::path& file) {
  require(message.find(file.stem().string()) == 0, "error without the file's name");
  require(message.size() < 400, "error too long");
  require(std::ranges::all_of(message, [](char c) { return c >= ' ' && c <= '~'; }),
          "error of more than one printable line");
}

}  // namespace

void readFuzzedMesh(std::string_view input) {
  const auto file = fileOf(input.empty() ? '\0' : input.front());
  if (!file) return;
  try {
    requireSound(readMesh({*file, input.substr(1)}).mesh);
  } catch (const InputError& error) {
    // What a broken glTF file calls a buffer file is named alone.
    if (file->extension() != ".gltf") requireReadable(error.what(), *file);
  }
}

}  // namespace morphgrid
