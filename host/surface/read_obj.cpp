#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <charconv>
#include <sstream>

#include "surface/mesh_formats.h"
#include "surface/polygon_mesh.h"
#include "surface/text_reader.h"

namespace morphgrid {
namespace {

/// A corner is `i`, `i/t`, `i//n` or `i/t/n`; i has to fit into an int. The rest counts too, for
/// tinyobjloader takes a third slash for another corner and a NUL for the end of the line.
void checkCorner(const TextReader& text, std::string_view word) {
  int index = 0;
  const std::size_t length = std::min(word.find('/'), word.size());
  const auto [end, problem] = std::from_chars(word.data(), word.data() + length, index);
  const bool isIndex = problem == std::errc() && end == word.data() + length && index != 0;
  if (isIndex && word.find_first_not_of("-0123456789/") == std::string_view::npos &&
      std::ranges::count(word, '/') <= 2) {
    return;
  }
  throw text.error(fmt::format(
      "a vertex of a face must be an integer other than 0, alone or as i/t, i//n or i/t/n, got {}",
      inQuotes(word)));
}

void checkFace(TextReader& text) {
  int corners = 0;
  for (std::string_view word = text.word(); !word.empty(); word = text.word()) {
    checkCorner(text, word);
    ++corners;
  }
  if (corners >= 3 && corners <= kMostCorners) return;
  throw text.error(fmt::format("a face must have 3 to {} vertices, got {}", kMostCorners, corners));
}

/// tinyobjloader reads what is no number as 0, keeps no line numbers and passes over lines that it
/// does not know: the lines that matter are looked at before.
void checkLines(const MeshSource& source) {
  TextReader text(source);
  while (text.nextLine()) {
    const std::string_view keyword = text.word();
    if (keyword == "v") {
      for (const char* const name : {"x", "y", "z"}) text.number(text.word(), name);
    }
    if (keyword == "f") checkFace(text);
  }
}

void addVertex(void* user, double x, double y, double z, double /*w*/) {
  auto& coordinates = static_cast<PolygonMesh*>(user)->coordinates;
  coordinates.insert(coordinates.end(), {x, y, z});
}

/// Negative indices count back from the latest vertex.
void addFace(void* user, tinyobj::index_t* corners, int count) {
  auto& polygons = *static_cast<PolygonMesh*>(user);
  const auto vertexCount = static_cast<int>(polygons.coordinates.size() / 3);
  for (int i = 0; i < count; ++i) {
    const int index = corners[i].vertex_index;
    polygons.corners.push_back(index > 0 ? index - 1 : vertexCount + index);
  }
  polygons.cornerCounts.push_back(count);
}

}  // namespace

TriangleMesh readObj(const MeshSource& source) {
  checkLines(source);
  PolygonMesh polygons;
  tinyobj::callback_t callbacks;
  callbacks.vertex_cb = addVertex;
  callbacks.index_cb = addFace;
  std::istringstream stream{std::string(source.bytes)};
  tinyobj::LoadObjWithCallback(stream, callbacks, &polygons);
  if (const auto bad = findBadCorner(polygons)) {
    throw source.error(fmt::format("face {}: vertex {} does not exist, there are 1 to {}",
                                   bad->polygon + 1, bad->index + 1,
                                   polygons.coordinates.size() / 3));
  }
  return triangulate(polygons);
}

}  // namespace morphgrid
