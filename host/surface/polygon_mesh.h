#pragma once
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "surface/triangle_mesh.h"

namespace morphgrid {

/// Polygons as a file holds them.
struct PolygonMesh {
  std::vector<double> coordinates;  ///< x, y and z of a vertex after the other.
  std::vector<int> corners;         ///< Vertex indices, of a polygon after the other.
  std::vector<int> cornerCounts;    ///< Corners of each polygon, 3 .. kMostCorners.
};

inline constexpr int kMostCorners = 4096;

struct BadCorner {
  int polygon;  ///< Counted from 0.
  int index;    ///< Below 0 or beyond the last vertex.
};

std::optional<BadCorner> findBadCorner(const PolygonMesh& polygons);

/// The corners of a strip's triangles, which all face as the first does. Those that a strip turns
/// with, of a corner twice, are left out.
std::vector<int> trianglesOfStrip(std::span<const int> strip);

/// What to tell of faces that no area can have: `count` of fewer than three corners.
std::vector<std::string> noticesOnFaces(std::size_t count);

/// Cuts polygons into triangles that face the same way: quads along the shorter diagonal that stays
/// inside, others by clipping ears. Corners must be in range.
TriangleMesh triangulate(const PolygonMesh& polygons);

}  // namespace morphgrid
