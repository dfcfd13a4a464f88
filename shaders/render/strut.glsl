// A strut as a ribbon that faces the eye: two triangles of a strut of the implicit topology.
// Location 0 is for what the colour shows.
#include "shared/render_types.h"
#include "shared/solver_types.h"
#include "solve/edge.glsl"

layout(binding = kBindingPositions) uniform isamplerBuffer positions;
layout(push_constant) uniform Push { StrutPush push; };

layout(location = 1) out float across;  // -1 .. 1
layout(location = 2) out vec3 side;     // Where `across` grows.
layout(location = 3) out vec3 facing;   // Towards the eye, at right angles to the strut.
layout(location = 4) out float pixels;  // Half the ribbon's width.
layout(location = 5) out vec2 fromEnds;  // In half widths: from the beginning, and from the end.

// Corners of two triangles: x along the strut, y across it.
const vec2 kCorners[kVerticesPerQuad] =
    vec2[](vec2(0, -1), vec2(1, -1), vec2(1, 1), vec2(0, -1), vec2(1, 1), vec2(0, 1));

const float kLeastHalfWidth = 0.75;  // Pixels: anything thinner breaks up.
const float kOverlap = 0.5;          // Half widths beyond the ends: closes the joints.

ivec3 latticeOf(int strut) {
  ivec3 count = ivec3(push.verticesU, push.verticesV, push.layers);
  count[push.direction] -= 1;
  return ivec3(strut % count.x, strut / count.x % count.y, strut / (count.x * count.y));
}

struct Ribbon {
  ivec3 lattice;  // The vertex that the strut leaves.
  int index;      // Of that vertex.
  vec3 arm;
};

Ribbon placeCorner() {
  ivec3 lattice = latticeOf(gl_VertexIndex / int(kVerticesPerQuad));
  ivec3 strides = ivec3(1, push.verticesU, push.verticesU * push.verticesV);
  int index = lattice.x + lattice.y * strides.y + lattice.z * strides.z;
  ivec4 from = texelFetch(positions, index);
  ivec4 to = texelFetch(positions, index + strides[push.direction]);

  vec3 arm = armBetween(from, to, push.resolution);

  vec2 corner = kCorners[gl_VertexIndex % int(kVerticesPerQuad)];
  vec3 start = vec3(from.xyz) * push.resolution;
  vec3 end = start + corner.x * arm;
  vec3 towardsEye = push.eye - end;
  float pixelSize = push.pixelSize * length(towardsEye);
  float halfWidth = max(push.halfWidth, kLeastHalfWidth * pixelSize);
  // Seen from its end, or without length, a ribbon has no side; nor would it be seen.
  vec3 sideways = cross(arm, towardsEye);
  side = sideways / max(length(sideways), 1e-20);
  vec3 backwards = cross(side, arm);
  facing = backwards / max(length(backwards), 1e-20);
  across = corner.y;
  pixels = halfWidth / pixelSize;
  vec3 along = arm / max(length(arm), 1e-20) * (2 * corner.x - 1);
  fromEnds = vec2(corner.x, 1 - corner.x) * length(arm) / halfWidth;
  vec3 outline = corner.y * side + kOverlap * along;
  gl_Position = push.clipFromLocal * vec4(end + halfWidth * outline, 1);
  return Ribbon(lattice, index, arm);
}
