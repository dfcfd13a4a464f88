#include "export/surface_files.h"

#include <fmt/format.h>

#include <iterator>
#include <string>

#include "core/atomic_file.h"

namespace morphgrid {
namespace {

template <typename... Values>
void append(std::string& text, fmt::format_string<Values...> format, Values&&... values) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Values>(values)...);
}

}  // namespace

void exportPly(const std::filesystem::path& path, const SurfaceMesh& surface) {
  std::string text;
  append(text, "ply\nformat ascii 1.0\ncomment morphgrid\nelement vertex {}\n",
         surface.vertices.cols());
  for (const char* property : {"x", "y", "z", "nx", "ny", "nz"}) {
    append(text, "property double {}\n", property);
  }
  append(text, "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
         surface.triangles.cols());
  for (Eigen::Index i = 0; i < surface.vertices.cols(); ++i) {
    const auto vertex = surface.vertices.col(i);
    const auto normal = surface.normals.col(i);
    append(text, "{} {} {} {} {} {}\n", vertex[0], vertex[1], vertex[2], normal[0], normal[1],
           normal[2]);
  }
  for (const auto& triangle : surface.triangles.colwise()) {
    append(text, "3 {} {} {}\n", triangle[0], triangle[1], triangle[2]);
  }
  writeFileAtomically(path, text);
}

void exportObj(const std::filesystem::path& path, const SurfaceMesh& surface) {
  std::string text = "# morphgrid\n";
  for (const auto& vertex : surface.vertices.colwise()) {
    append(text, "v {} {} {}\n", vertex[0], vertex[1], vertex[2]);
  }
  for (const auto& normal : surface.normals.colwise()) {
    append(text, "vn {} {} {}\n", normal[0], normal[1], normal[2]);
  }
  for (const auto& triangle : surface.triangles.colwise()) {
    const Eigen::Vector3i number = triangle.array() + 1;  // OBJ counts from 1.
    append(text, "f {0}//{0} {1}//{1} {2}//{2}\n", number[0], number[1], number[2]);
  }
  writeFileAtomically(path, text);
}

}  // namespace morphgrid
