// A strut as a tube: a prism, with a tip at an end that no other tube hides.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "render/strut_shown.glsl"

layout(location = 1) out vec3 normal;
layout(location = 2) out vec3 towardsEye;
layout(location = 3) out float pixels;  // The radius.

// Corners of a side's triangles, counter-clockwise from outside: x along the strut, from the tip before its
// beginning to that beyond its end; y around it.
const ivec2 kCorners[kVerticesPerTubeSide] =
    ivec2[](ivec2(-1, 0), ivec2(0, 1), ivec2(0, 0), ivec2(0, 0), ivec2(0, 1), ivec2(1, 0),
            ivec2(1, 0), ivec2(0, 1), ivec2(1, 1), ivec2(1, 0), ivec2(1, 1), ivec2(2, 0));

const float kSideAngle = 6.28318530718 / float(kTubeSides);

// A vector of unit length at right angles to the axis and to where the eye is: a prism with a
// corner there is as wide as the tube.
vec3 sideOf(Strut strut, vec3 axis) {
  vec3 sideways = cross(axis, normalize(push.eye - strut.start));
  if (length(sideways) < 1e-4) {  // The eye is on the axis.
    sideways = cross(axis, abs(axis.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0));
  }
  return sideways / max(length(sideways), 1e-20);
}

Strut placeCorner() {
  Strut strut = strutAt(gl_VertexIndex / int(kVerticesPerTube));
  int place = gl_VertexIndex % int(kVerticesPerTube);
  ivec2 corner = kCorners[place % int(kVerticesPerTubeSide)];
  bool atEnd = corner.x > 0;
  ivec3 vertex = strut.lattice;
  vertex[push.direction] += int(atEnd);
  vec3 centre = strut.start + (atEnd ? strut.arm : vec3(0));
  vec3 axis = strut.arm / max(length(strut.arm), 1e-20);

  float angle = kSideAngle * float(place / int(kVerticesPerTubeSide) + corner.y);
  vec3 side = sideOf(strut, axis);
  normal = cos(angle) * side + sin(angle) * cross(axis, side);
  // Inside a layer tubes cross at every vertex, and hide each other's ends.
  if (corner.x != int(atEnd) && isOnBorder(push.size, vertex.xy)) {
    normal = atEnd ? axis : -axis;
  }
  float radius = halfWidthAt(centre);
  vec3 outline = centre + radius * normal;
  towardsEye = push.eye - outline;
  pixels = radius / pixelSizeAt(centre);
  gl_Position = push.clipFromLocal * vec4(outline, 1);
  return strut;
}

void main() { show(placeCorner()); }
