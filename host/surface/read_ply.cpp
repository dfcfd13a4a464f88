#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "surface/mesh_formats.h"
#include "surface/ply_values.h"
#include "surface/polygon_mesh.h"

namespace morphgrid {
namespace {

/// A property's values in one row: a list's are many.
using Values = std::vector<double>;

/// Where a property stands in a row, if it does.
std::optional<std::size_t> findProperty(const PlyElement& element, std::string_view name,
                                        bool isList) {
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const PlyProperty& property = element.properties[i];
    if (property.name == name && property.countType.has_value() == isList) return i;
  }
  return std::nullopt;
}

class PlyReader {
 public:
  explicit PlyReader(const MeshSource& source) : source_(source) {}

  TriangleMesh read() {
    TextReader text(source_);
    const PlyHeader header = readPlyHeader(text);
    PlyValues values(source_, header.format, text);
    for (const PlyElement& element : header.elements) readElement(element, values);
    values.requireEnd();
    requireRange();
    return triangulate(polygons_);
  }

 private:
  void readElement(const PlyElement& element, PlyValues& values) {
    requireRows(element, values);
    if (element.name == "vertex") {
      readVertices(element, values);
    } else if (element.name == "face") {
      readFaces(element, values);
    } else {
      readRows(element, values, [](const std::vector<Values>&) {});
    }
  }

  /// Nothing is read, nor memory taken, for rows that the file cannot hold.
  void requireRows(const PlyElement& element, const PlyValues& values) const {
    std::size_t rowBytes = 0;
    for (const PlyProperty& property : element.properties) {
      rowBytes += values.leastBytes(property.countType.value_or(property.type));
    }
    if (element.rowCount == 0) return;
    if (rowBytes > 0 && element.rowCount <= values.bytesLeft() / rowBytes) return;
    throw values.error(
        fmt::format("{} rows of {} do not fit into the {} bytes that are left of the file",
                    element.rowCount, inQuotes(element.name), values.bytesLeft()));
  }

  template <typename Use>
  void readRows(const PlyElement& element, PlyValues& values, Use use) {
    std::vector<Values> row(element.properties.size());
    for (std::size_t i = 0; i < element.rowCount; ++i) {
      for (std::size_t j = 0; j < row.size(); ++j)
        readValues(element.properties[j], values, row[j]);
      use(row);
    }
  }

  static void readValues(const PlyProperty& property, PlyValues& values, Values& read) {
    const std::size_t count = property.countType ? readCount(property, values) : 1;
    read.clear();
    for (std::size_t i = 0; i < count; ++i) read.push_back(values.next(property.type));
  }

  static std::size_t readCount(const PlyProperty& property, PlyValues& values) {
    const double count = values.next(*property.countType);
    const std::size_t most = values.bytesLeft() / values.leastBytes(property.type);
    if (count >= 0 && count <= static_cast<double>(most) && count == std::floor(count))
      return count;
    throw values.error(
        fmt::format("a list of {} must hold 0 to {} values, as many as fit into the "
                    "rest of the file, got {}",
                    inQuotes(property.name), most, count));
  }

  void readVertices(const PlyElement& element, PlyValues& values) {
    std::array<std::size_t, 3> places{};
    std::ranges::transform(std::array{"x", "y", "z"}, places.begin(), [&](const char* name) {
      const auto place = findProperty(element, name, false);
      if (!place)
        throw source_.error(fmt::format("the element vertex lacks the property {}", name));
      return *place;
    });
    readRows(element, values, [&](const std::vector<Values>& row) {
      for (const std::size_t place : places) polygons_.coordinates.push_back(row[place].front());
    });
  }

  void readFaces(const PlyElement& element, PlyValues& values) {
    auto place = findProperty(element, "vertex_indices", true);
    if (!place) place = findProperty(element, "vertex_index", true);
    if (!place) throw source_.error("the element face lacks the list property vertex_indices");
    readRows(element, values,
             [&](const std::vector<Values>& row) { addFace(row[*place], values); });
  }

  void addFace(const Values& corners, const PlyValues& values) {
    if (corners.size() < 3 || corners.size() > kMostCorners) {
      throw values.error(
          fmt::format("a face must have 3 to {} vertices, got {}", kMostCorners, corners.size()));
    }
    for (const double corner : corners) addCorner(corner, values);
    polygons_.cornerCounts.push_back(static_cast<int>(corners.size()));
  }

  void addCorner(double corner, const PlyValues& values) {
    if (!(corner >= 0 && corner <= kMostMeshBytes && corner == std::floor(corner))) {
      throw values.error(fmt::format("a vertex index must be an integer >= 0, got {}", corner));
    }
    polygons_.corners.push_back(static_cast<int>(corner));
  }

  /// When all is read: faces may come before the vertices.
  void requireRange() const {
    if (const auto bad = findBadCorner(polygons_)) {
      throw source_.error(fmt::format("face {}: vertex {} does not exist, there are 0 to {}",
                                      bad->polygon, bad->index,
                                      static_cast<int>(polygons_.coordinates.size() / 3) - 1));
    }
  }

  const MeshSource& source_;
  PolygonMesh polygons_;
};

}  // namespace

TriangleMesh readPly(const MeshSource& source) { return PlyReader(source).read(); }

}  // namespace morphgrid
