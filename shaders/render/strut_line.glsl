// A strut as a line, or one line for the struts between every n-th vertex.
#include "shared/render_types.h"
#include "shared/solver_types.h"
#include "solve/edge.glsl"

layout(binding = kBindingPositions) uniform isamplerBuffer positions;
layout(push_constant) uniform Push { StrutPush push; };

layout(location = 0) flat out vec3 lineColor;

// Every n-th of `count` vertices, and the last.
int drawnCount(int count) { return (count - 2) / push.stride + 2; }
int drawnVertex(int n, int count) { return min(n * push.stride, count - 1); }

int indexOf(ivec3 drawn) {
  int i = drawnVertex(drawn.x, push.verticesU);
  int j = drawnVertex(drawn.y, push.verticesV);
  return i + (j + drawn.z * push.verticesV) * push.verticesU;
}

// Places an end of the line; returns the index of the vertex that its first strut leaves.
int placeEnd() {
  int line = gl_VertexIndex / int(kVerticesPerLine);
  ivec3 count = ivec3(drawnCount(push.verticesU), drawnCount(push.verticesV), push.layers);
  count[push.direction] -= 1;
  ivec3 first = ivec3(line % count.x, line / count.x % count.y, line / (count.x * count.y));
  ivec3 end = first;
  end[push.direction] += gl_VertexIndex % int(kVerticesPerLine);
  vec3 point = vec3(texelFetch(positions, indexOf(end)).xyz) * push.resolution;
  gl_Position = push.clipFromLocal * vec4(point, 1);
  return indexOf(first);
}
