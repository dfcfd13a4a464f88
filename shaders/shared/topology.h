// Compiles as GLSL and as C++: what a grid consists of, who is whose neighbour, and where it is
// stored. A grid has size.x x size.y columns of vertices in size.z layers; what belongs to a
// vertex, and to the struts that leave it along the axes 0, 1, 2 (+u, +v, +w), is stored at the
// vertex's index. A cell, the paper's node, lies between four columns and bears the name of the one
// with the lowest indices.
#ifndef MORPHGRID_TOPOLOGY_H
#define MORPHGRID_TOPOLOGY_H
#ifdef __cplusplus
#include <glm/glm.hpp>
namespace morphgrid {
using glm::ivec2;
using glm::ivec3;
#define MORPHGRID_INLINE inline
#else
#define MORPHGRID_INLINE
#endif

// A lattice of size.x x size.y points, stored row by row: a layer's vertices, or a coarse level's
// points.
MORPHGRID_INLINE int pointIndex(ivec2 size, ivec2 point) { return point.y * size.x + point.x; }

MORPHGRID_INLINE bool hasPoint(ivec2 size, ivec2 point) {
  return all(greaterThanEqual(point, ivec2(0))) && all(lessThan(point, size));
}

MORPHGRID_INLINE ivec2 nearestPoint(ivec2 size, ivec2 point) {
  return clamp(point, ivec2(0), size - 1);
}

// The lattice of every stride-th point along both directions, and the last: its size, and where it
// takes its points from.
MORPHGRID_INLINE ivec2 thinnedSize(ivec2 size, int stride) { return (size - 2) / stride + 2; }

MORPHGRID_INLINE ivec2 thinnedPoint(ivec2 size, int stride, ivec2 point) {
  return min(point * stride, size - 1);
}

MORPHGRID_INLINE int vertexIndex(ivec3 size, ivec3 vertex) {
  return (vertex.z * size.y + vertex.y) * size.x + vertex.x;
}

MORPHGRID_INLINE ivec3 unitStep(int axis) { return ivec3(axis == 0, axis == 1, axis == 2); }

// `steps` further along an axis, whether there is such a vertex or not.
MORPHGRID_INLINE ivec3 neighbour(ivec3 vertex, int axis, int steps) {
  return vertex + steps * unitStep(axis);
}

// Whether the grid has what spans the vertices from `low` to `high`, which are one step apart at
// most along each axis: a vertex, a strut or a face. Nothing else knows the outline of the grid.
MORPHGRID_INLINE bool hasSpan(ivec3 size, ivec3 low, ivec3 high) {
  return all(greaterThanEqual(low, ivec3(0))) && all(lessThan(high, size));
}

MORPHGRID_INLINE bool hasVertex(ivec3 size, ivec3 vertex) { return hasSpan(size, vertex, vertex); }

MORPHGRID_INLINE bool hasColumn(ivec3 size, ivec2 column) {
  return hasVertex(size, ivec3(column, 0));
}

MORPHGRID_INLINE bool hasCell(ivec3 size, ivec2 cell) {
  return hasSpan(size, ivec3(cell, 0), ivec3(cell + 1, 0));
}

// The strut that leaves a vertex along an axis.
MORPHGRID_INLINE bool hasStrut(ivec3 size, ivec3 from, int axis) {
  return hasSpan(size, from, neighbour(from, axis, 1));
}

// The corner between two struts from its apex, which end at a and b, at right angles to each other.
MORPHGRID_INLINE bool hasCorner(ivec3 size, ivec3 a, ivec3 b) {
  return hasSpan(size, min(a, b), max(a, b));
}

// Whether the column is on the border of the grid or of a hole: not all four cells around it exist.
MORPHGRID_INLINE bool isOnBorder(ivec3 size, ivec2 column) {
  return !(hasCell(size, column) && hasCell(size, column - ivec2(1, 0)) &&
           hasCell(size, column - ivec2(0, 1)) && hasCell(size, column - ivec2(1, 1)));
}

#undef MORPHGRID_INLINE
#ifdef __cplusplus
}  // namespace morphgrid
#endif
#endif
