// A strut as a line, or one line for the struts between every n-th vertex, in the colour of the first
// strut's strain or, with kShowsShares, of its share.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/render_types.h"
#include "shared/share_color.h"
#include "shared/solver_types.h"
#include "shared/strain_color.h"
#include "shared/topology.h"
#include "energy/strut.glsl"

layout(constant_id = kConstantShowsShares) const bool kShowsShares = false;

layout(binding = kBindingPositions) uniform isamplerBuffer positions;
layout(binding = kBindingRest) uniform isamplerBuffer restLengths;
layout(binding = kBindingShares) uniform samplerBuffer shares;
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

float strainOf(ivec3 from) {
  int index = vertexIndex(push.size, from);
  int end = vertexIndex(push.size, neighbour(from, push.direction, 1));
  Edge e = edgeBetween(texelFetch(positions, index), texelFetch(positions, end), push.resolution);
  int rest = texelFetch(restLengths, index)[push.direction];
  return strutStrain(e, Spring(rest, push.restResolution, 1.0));
}

void main() {
  ivec3 from = placeEnd();
  if (kShowsShares) {
    lineColor = shareColor(texelFetch(shares, vertexIndex(push.size, from))[push.direction]);
  } else {
    lineColor = strainColor(strainOf(from));
  }
}
