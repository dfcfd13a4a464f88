// Level 1: a column of vertices moves rigidly about its centre, the vertex in the middle layer:
// u(x) = t + w x (x - centre).
#include "shared/topology.h"
#include "energy/arm.glsl"

layout(binding = kBindingPositions, rgba32i) readonly uniform iimageBuffer positions;
layout(push_constant) uniform Push { ColumnPush push; };

int vertexCount() { return push.grid.size.x * push.grid.size.y * push.grid.size.z; }

// In the nearest column that there is.
int indexInColumn(ivec2 column, int layer) {
  return vertexIndex(push.grid.size, ivec3(nearestPoint(ivec2(push.grid.size), column), layer));
}

ivec4 positionAt(ivec2 column, int layer) {
  return imageLoad(positions, indexInColumn(column, layer));
}

ivec4 centreOf(ivec2 column) { return positionAt(column, push.centreLayer); }

vec3 between(ivec4 from, ivec4 to) { return armBetween(from, to, push.grid.resolution); }
