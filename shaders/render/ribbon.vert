// A strut as a ribbon that faces the eye: two triangles.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "render/strut_shown.glsl"

layout(location = 1) out float across;  // -1 .. 1
layout(location = 2) out vec3 side;     // Where `across` grows.
layout(location = 3) out vec3 facing;   // Towards the eye, at right angles to the strut.
layout(location = 4) out float pixels;  // Half the ribbon's width.
layout(location = 5) out vec2 fromEnds;  // In half widths: from the beginning, and from the end.

// Corners of two triangles: x along the strut, y across it.
const vec2 kCorners[kVerticesPerQuad] =
    vec2[](vec2(0, -1), vec2(1, -1), vec2(1, 1), vec2(0, -1), vec2(1, 1), vec2(0, 1));

const float kOverlap = 0.5;  // Half widths beyond the ends: closes the joints.

Strut placeCorner() {
  Strut strut = strutAt(gl_VertexIndex / int(kVerticesPerQuad));
  vec2 corner = kCorners[gl_VertexIndex % int(kVerticesPerQuad)];
  vec3 end = strut.start + corner.x * strut.arm;
  float halfWidth = halfWidthAt(end);
  // Seen from its end, or without length, a ribbon has no side; nor would it be seen.
  vec3 sideways = cross(strut.arm, push.eye - end);
  side = sideways / max(length(sideways), 1e-20);
  vec3 backwards = cross(side, strut.arm);
  facing = backwards / max(length(backwards), 1e-20);
  across = corner.y;
  pixels = halfWidth / pixelSizeAt(end);
  vec3 along = strut.arm / max(length(strut.arm), 1e-20) * (2 * corner.x - 1);
  fromEnds = vec2(corner.x, 1 - corner.x) * length(strut.arm) / halfWidth;
  vec3 outline = corner.y * side + kOverlap * along;
  gl_Position = push.clipFromLocal * vec4(end + halfWidth * outline, 1);
  return strut;
}

void main() { show(placeCorner()); }
