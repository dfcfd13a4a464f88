#include "export/surface_files.h"

#include <fmt/compile.h>

#include <bit>
#include <iterator>
#include <string>

#include "core/atomic_file.h"
#include "core/write_rows.h"

namespace morphgrid {
namespace {

template <typename Format, typename... Values>
void append(std::string& text, const Format& format, const Values&... values) {
  fmt::format_to(std::back_inserter(text), format, values...);
}

template <typename Column>
void appendBytes(std::string& bytes, const Column& column) {
  const Eigen::Vector3<typename Column::Scalar> values = column;
  bytes.append(reinterpret_cast<const char*>(values.data()), sizeof(values));
}

}  // namespace

void exportPly(const std::filesystem::path& path, const SurfaceMesh& surface) {
  static_assert(std::endian::native == std::endian::little);
  std::string header;
  append(
      header,
      FMT_COMPILE("ply\nformat binary_little_endian 1.0\ncomment morphgrid\nelement vertex {}\n"),
      surface.vertices.cols());
  for (const char* property :
       {"double x", "double y", "double z", "float nx", "float ny", "float nz"}) {
    append(header, FMT_COMPILE("property {}\n"), property);
  }
  append(header,
         FMT_COMPILE("element face {}\nproperty list uchar int vertex_indices\nend_header\n"),
         surface.triangles.cols());
  writeFileAtomically(path, [&](std::ostream& stream) {
    stream << header;
    writeRows(stream, surface.vertices.cols(), [&](std::string& bytes, Eigen::Index i) {
      appendBytes(bytes, surface.vertices.col(i));
      appendBytes(bytes, surface.normals.col(i).cast<float>());
    });
    writeRows(stream, surface.triangles.cols(), [&](std::string& bytes, Eigen::Index i) {
      bytes.push_back(3);
      appendBytes(bytes, surface.triangles.col(i));
    });
  });
}

void exportObj(const std::filesystem::path& path, const SurfaceMesh& surface) {
  const auto writeVectors = [](std::ostream& stream, const char* keyword,
                               const Eigen::Matrix3Xd& vectors) {
    writeRows(stream, vectors.cols(), [&](std::string& text, Eigen::Index i) {
      append(text, FMT_COMPILE("{} {} {} {}\n"), keyword, vectors(0, i), vectors(1, i),
             vectors(2, i));
    });
  };
  writeFileAtomically(path, [&](std::ostream& stream) {
    stream << "# morphgrid\n";
    writeVectors(stream, "v", surface.vertices);
    writeVectors(stream, "vn", surface.normals);
    writeRows(stream, surface.triangles.cols(), [&](std::string& text, Eigen::Index i) {
      const Eigen::Vector3i number = surface.triangles.col(i).array() + 1;  // OBJ counts from 1.
      append(text, FMT_COMPILE("f {0}//{0} {1}//{1} {2}//{2}\n"), number[0], number[1], number[2]);
    });
  });
}

}  // namespace morphgrid
