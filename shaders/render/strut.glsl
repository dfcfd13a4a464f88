// The struts of the implicit topology: which one a vertex belongs to, and where it lies.
// Location 0 is for what the colour shows.
#include "shared/render_types.h"
#include "shared/solver_types.h"
#include "shared/topology.h"
#include "energy/strut.glsl"

layout(binding = kBindingPositions) uniform isamplerBuffer positions;
layout(push_constant) uniform Push { StrutPush push; };

const float kLeastHalfWidth = 0.75;  // Pixels: anything thinner breaks up.

struct Strut {
  ivec3 lattice;  // The vertex that it leaves.
  int index;      // Index of that vertex.
  vec3 start;
  vec3 arm;
};

ivec3 latticeOf(int strut) {
  ivec3 count = push.size - unitStep(push.direction);
  return ivec3(strut % count.x, strut / count.x % count.y, strut / (count.x * count.y));
}

Strut strutAt(int n) {
  ivec3 lattice = latticeOf(n);
  int index = vertexIndex(push.size, lattice);
  ivec4 from = texelFetch(positions, index);
  ivec4 to =
      texelFetch(positions, vertexIndex(push.size, neighbour(lattice, push.direction, 1)));
  return Strut(lattice, index, vec3(from.xyz) * push.resolution,
               armBetween(from, to, push.resolution));
}

// How wide a strut is at a point, in pixels and in spacings.
float pixelSizeAt(vec3 point) { return push.pixelSize * length(push.eye - point); }
float halfWidthAt(vec3 point) {
  return max(push.halfWidth, kLeastHalfWidth * pixelSizeAt(point));
}
