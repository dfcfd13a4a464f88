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

/// A property's values in one row: a list's are many. None where nobody asked for the property.
using Values = std::vector<double>;

/// Where properties stand in a row.
using Places = std::vector<std::size_t>;

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

  NotedMesh read() {
    TextReader text(source_);
    const PlyHeader header = readPlyHeader(text);
    PlyValues values(source_, header.format, text);
    for (const PlyElement& element : header.elements) readElement(element, values);
    values.requireEnd();
    requireRange();
    if (polygons_.cornerCounts.empty()) refuseRangeGrid(header);
    return {triangulate(polygons_), noticesOnFaces(smallFaces_)};
  }

 private:
  void readElement(const PlyElement& element, PlyValues& values) {
    requireRows(element, values);
    if (element.rowCount == 0) return;
    if (element.name == "vertex") {
      readVertices(element, values);
    } else if (element.name == "face") {
      readLists(element, values, [&](const Values& corners) { addFace(corners, values); });
    } else if (element.name == "tristrips") {
      readLists(element, values, [&](const Values& strips) { addStrips(strips, values); });
    } else {
      readRows(element, values, {}, [](const std::vector<Values>&) {});
    }
  }

  /// Nothing is read, nor memory taken, for rows that the file cannot hold.
  static void requireRows(const PlyElement& element, const PlyValues& values) {
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
  static void readRows(const PlyElement& element, PlyValues& values, const Places& wanted,
                       const Use& use) {
    std::vector<Values> row(element.properties.size());
    std::vector<bool> isWanted(row.size());
    for (const std::size_t place : wanted) isWanted[place] = true;
    for (std::size_t i = 0; i < element.rowCount; ++i) {
      for (std::size_t j = 0; j < row.size(); ++j) {
        row[j].clear();
        readValues(element.properties[j], values, isWanted[j] ? &row[j] : nullptr);
      }
      use(row);
    }
  }

  /// read: null to pass over them.
  static void readValues(const PlyProperty& property, PlyValues& values, Values* read) {
    const std::size_t count = property.countType ? readCount(property, values) : 1;
    for (std::size_t i = 0; i < count; ++i) {
      if (read) {
        read->push_back(values.next(property.type));
      } else {
        values.skip(property.type);
      }
    }
  }

  static std::size_t readCount(const PlyProperty& property, PlyValues& values) {
    const double count = values.next(*property.countType);
    const std::size_t most = values.bytesLeft() / values.leastBytes(property.type);
    if (count >= 0 && count <= static_cast<double>(most) && count == std::floor(count))
      return static_cast<std::size_t>(count);
    throw values.error(
        fmt::format("a list of {} must hold 0 to {} values, as many as fit into the "
                    "rest of the file, got {}",
                    inQuotes(property.name), most, count));
  }

  void readVertices(const PlyElement& element, PlyValues& values) {
    Places places;
    for (const char* const name : {"x", "y", "z"}) {
      const auto place = findProperty(element, name, false);
      if (!place)
        throw source_.error(fmt::format("the element vertex lacks the property {}", name));
      places.push_back(*place);
    }
    readRows(element, values, places, [&](const std::vector<Values>& row) {
      for (const std::size_t place : places) polygons_.coordinates.push_back(row[place].front());
    });
  }

  /// use: is called with the vertex indices of each row.
  template <typename Use>
  void readLists(const PlyElement& element, PlyValues& values, const Use& use) {
    auto place = findProperty(element, "vertex_indices", true);
    if (!place) place = findProperty(element, "vertex_index", true);
    if (!place) {
      throw source_.error(
          fmt::format("the element {} lacks the list property vertex_indices", element.name));
    }
    readRows(element, values, {*place}, [&](const std::vector<Values>& row) { use(row[*place]); });
  }

  void addFace(const Values& corners, const PlyValues& values) {
    if (corners.size() > kMostCorners) {
      throw values.error(
          fmt::format("a face must have 3 to {} vertices, got {}", kMostCorners, corners.size()));
    }
    if (corners.size() < 3) {
      ++smallFaces_;
      return;
    }
    for (const double corner : corners) polygons_.corners.push_back(indexOf(corner, values));
    polygons_.cornerCounts.push_back(static_cast<int>(corners.size()));
  }

  /// A list of strips, each but the last ended by -1.
  void addStrips(const Values& strips, const PlyValues& values) {
    std::vector<int> strip;
    for (const double corner : strips) {
      if (corner == -1) {
        addStrip(strip);
        strip.clear();
      } else {
        strip.push_back(indexOf(corner, values));
      }
    }
    addStrip(strip);
  }

  void addStrip(const std::vector<int>& strip) {
    const std::vector<int> corners = trianglesOfStrip(strip);
    polygons_.corners.insert(polygons_.corners.end(), corners.begin(), corners.end());
    polygons_.cornerCounts.insert(polygons_.cornerCounts.end(), corners.size() / 3, 3);
  }

  static int indexOf(double corner, const PlyValues& values) {
    if (corner >= 0 && corner <= kMostMeshBytes && corner == std::floor(corner)) {
      return static_cast<int>(corner);
    }
    throw values.error(fmt::format("a vertex index must be an integer >= 0, got {}", corner));
  }

  /// When all is read: faces may come before the vertices.
  void requireRange() const {
    if (const auto bad = findBadCorner(polygons_)) {
      throw source_.error(fmt::format("face {}: vertex {} does not exist, there are 0 to {}",
                                      bad->polygon, bad->index,
                                      static_cast<int>(polygons_.coordinates.size() / 3) - 1));
    }
  }

  void refuseRangeGrid(const PlyHeader& header) const {
    const bool isGrid = std::ranges::any_of(
        header.elements, [](const PlyElement& element) { return element.name == "range_grid"; });
    if (!isGrid) return;
    throw source_.error(
        fmt::format("holds a range grid of {}, as a scanner sees them, but no faces: it must be "
                    "meshed first",
                    countOf(polygons_.coordinates.size() / 3, "point")));
  }

  const MeshSource& source_;
  PolygonMesh polygons_;
  std::size_t smallFaces_ = 0;  ///< Of fewer than three corners.
};

}  // namespace

NotedMesh readPly(const MeshSource& source) { return PlyReader(source).read(); }

}  // namespace morphgrid
