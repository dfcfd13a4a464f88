#include "export/surface_files.h"

#include <fmt/format.h>

#include <bit>
#include <iterator>
#include <string>

#include "core/atomic_file.h"

namespace morphgrid {
namespace {

template <typename... Values>
void append(std::string& text, fmt::format_string<Values...> format, Values&&... values) {
  fmt::format_to(std::back_inserter(text), format, std::forward<Values>(values)...);
}

template <typename Column>
void appendBytes(std::string& bytes, const Column& column) {
  const Eigen::Vector3<typename Column::Scalar> values = column;
  bytes.append(reinterpret_cast<const char*>(values.data()), sizeof(values));
}

}  // namespace

void exportPly(const std::filesystem::path& path, const SurfaceMesh& surface) {
  static_assert(std::endian::native == std::endian::little);
  std::string bytes;
  append(bytes, "ply\nformat binary_little_endian 1.0\ncomment morphgrid\nelement vertex {}\n",
         surface.vertices.cols());
  for (const char* property :
       {"double x", "double y", "double z", "float nx", "float ny", "float nz"}) {
    append(bytes, "property {}\n", property);
  }
  append(bytes, "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
         surface.triangles.cols());
  for (Eigen::Index i = 0; i < surface.vertices.cols(); ++i) {
    appendBytes(bytes, surface.vertices.col(i));
    appendBytes(bytes, surface.normals.col(i).cast<float>());
  }
  for (const auto& triangle : surface.triangles.colwise()) {
    bytes.push_back(3);
    appendBytes(bytes, triangle);
  }
  writeFileAtomically(path, bytes);
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
