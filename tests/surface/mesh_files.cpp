#include "tests/surface/mesh_files.h"

#include <fmt/ranges.h>

#include "core/error.h"
#include "surface/load_mesh.h"
#include "surface/mesh_formats.h"

namespace morphgrid {

TriangleMesh meshOf(const std::string& name, std::string_view bytes) {
  const std::filesystem::path file = name;
  return readMesh({file, bytes}).mesh;
}

std::string noticesOf(const std::string& name, std::string_view bytes) {
  const std::filesystem::path file = name;
  return fmt::format("{}", fmt::join(readMesh({file, bytes}).notices, "\n"));
}

std::string problemOf(const std::string& name, std::string_view bytes) {
  try {
    meshOf(name, bytes);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string problemOfFile(const std::filesystem::path& file) {
  try {
    loadMesh(file);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string withLineEnds(std::string_view text, std::string_view end) {
  std::string result;
  for (const char c : text) {
    if (c == '\n') {
      result += end;
    } else {
      result += c;
    }
  }
  return result;
}

double areaOf(const TriangleMesh& mesh) {
  double area = 0;
  for (const auto triangle : mesh.triangles.colwise()) {
    const Eigen::Vector3d a = mesh.vertices.col(triangle[0]);
    area +=
        (mesh.vertices.col(triangle[1]) - a).cross(mesh.vertices.col(triangle[2]) - a).norm() / 2;
  }
  return area;
}

}  // namespace morphgrid
