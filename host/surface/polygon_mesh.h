#pragma once
#include <optional>
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

/// Cuts polygons into triangles that face the same way: quads along the shorter diagonal that stays
/// inside, others by clipping ears. Corners must be in range.
TriangleMesh triangulate(const PolygonMesh& polygons);

}  // namespace morphgrid
