// A strut as a line, or one line for the struts between every n-th vertex.
#include "shared/render_types.h"
#include "shared/solver_types.h"
#include "shared/topology.h"
#include "energy/strut.glsl"

layout(binding = kBindingPositions) uniform isamplerBuffer positions;
layout(push_constant) uniform Push { StrutPush push; };

layout(location = 0) flat out vec3 lineColor;

ivec3 vertexAt(ivec3 drawn) {
  return ivec3(thinnedPoint(push.size.xy, push.stride, drawn.xy), drawn.z);
}

vec3 pointAt(ivec3 vertex) {
  return vec3(texelFetch(positions, vertexIndex(push.size, vertex)).xyz) * push.resolution;
}

// Places an end of the line; returns the vertex that its first strut leaves.
ivec3 placeEnd() {
  int line = gl_VertexIndex / int(kVerticesPerLine);
  ivec3 drawnSize = ivec3(thinnedSize(push.size.xy, push.stride), push.size.z);
  ivec3 count = drawnSize - unitStep(push.direction);
  ivec3 first = ivec3(line % count.x, line / count.x % count.y, line / (count.x * count.y));
  ivec3 end = neighbour(first, push.direction, gl_VertexIndex % int(kVerticesPerLine));
  gl_Position = push.clipFromLocal * vec4(pointAt(vertexAt(end)), 1);
  return vertexAt(first);
}
