// Level 1: a column of vertices moves rigidly about its centre, the vertex in the middle layer:
// u(x) = t + w x (x - centre).
#include "solve/arm.glsl"

layout(binding = kBindingPositions, rgba32i) readonly uniform iimageBuffer positions;
layout(push_constant) uniform Push { ColumnPush push; };

int vertexIndex(ivec2 column, int layer) {
  ivec2 nearest = clamp(column, ivec2(0), ivec2(push.grid.verticesU, push.grid.verticesV) - 1);
  return (layer * push.grid.verticesV + nearest.y) * push.grid.verticesU + nearest.x;
}

ivec4 positionAt(ivec2 column, int layer) { return imageLoad(positions, vertexIndex(column, layer)); }

ivec4 centreOf(ivec2 column) { return positionAt(column, push.centreLayer); }

vec3 between(ivec4 from, ivec4 to) { return armBetween(from, to, push.grid.resolution); }
