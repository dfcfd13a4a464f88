// A strut of a frame as the bar that it is: a prism of its width and height along a cubic curve, which turns
// with the joints at its ends and leaves them as they hold it. host/export/bar_mesh.cpp makes the same.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "render/strut_shown.glsl"
#include "energy/beam.glsl"

layout(binding = kBindingPrinted) uniform samplerBuffer printed;

layout(location = 1) out vec3 normal;
layout(location = 2) out vec3 towardsEye;
layout(location = 3) out float pixels;  // Half the smaller side.

// Corners of a quad's triangles, counter-clockwise from outside.
const ivec2 kCorners[kVerticesPerQuad] =
    ivec2[](ivec2(0, 0), ivec2(0, 1), ivec2(1, 1), ivec2(0, 0), ivec2(1, 1), ivec2(1, 0));

// Signs along n and b of a section's corners, counter-clockwise about the bar.
const vec2 kSection[4] = vec2[](vec2(-1, -1), vec2(1, -1), vec2(1, 1), vec2(-1, 1));

// Where bars cross their faces lie in one plane: those to +u are seen, then those to +v. Half widths: as few
// as the depth's precision allows, or a sliver of a bar's side would be seen through the face that it meets.
const float kPrecedence = 0.004;

struct Section {
  vec3 centre;
  vec3 along, n, b;
};

BarEnd endAt(ivec3 vertex, int strut) {
  int index = vertexIndex(push.size, vertex);
  int jointCount = push.size.x * push.size.y * push.size.z;
  Joint joint = Joint(ivec4(0), texelFetch(positions, jointCount + index));
  vec4 directions = texelFetch(printed, strut);
  return barEndAt(joint, push.direction == 0 ? directions.xy : directions.zw,
                  push.direction == 2);
}

// By how much a bar reaches beyond a joint: where its line ends, as far as closes the joint.
float reachBeyond(ivec3 nextStrut) {
  bool goesOn = push.direction == 2 || hasStrut(push.size, nextStrut, push.direction);
  return goesOn ? 0 : push.halfWidth;
}

Section sectionAt(Strut strut, int n) {
  ivec3 last = neighbour(strut.lattice, push.direction, 1);
  BarEnd from = endAt(strut.lattice, strut.index), to = endAt(last, strut.index);
  float s = float(n) / float(kBarPieces);
  vec3 a = length(strut.arm) * from.t, b = length(strut.arm) * to.t;
  vec3 slope = 6 * s * (1 - s) * strut.arm + (1 - s) * (1 - 3 * s) * a + s * (3 * s - 2) * b;
  Section section;
  section.along = slope / max(length(slope), 1e-20);
  vec3 across = cross(section.along, mix(from.n, to.n, s));
  section.b = across / max(length(across), 1e-20);
  section.n = cross(section.b, section.along);
  section.centre = strut.start + s * s * (3 - 2 * s) * strut.arm +
                   s * (1 - s) * ((1 - s) * a - s * b);
  if (n == 0) {
    section.centre -=
        reachBeyond(neighbour(strut.lattice, push.direction, -1)) * section.along;
  } else if (n == int(kBarPieces)) {
    section.centre += reachBeyond(last) * section.along;
  }
  return section;
}

// Which section a vertex is on, which of its corners it is, and the side that it belongs to: 0 .. 3 along the
// bar, the one from that corner of the section to the next; 4 at its beginning, 5 at its end.
struct BarCorner {
  int section, corner, side;
};

BarCorner cornerOf(int place) {
  int quad = place / int(kVerticesPerQuad);
  ivec2 corner = kCorners[place % int(kVerticesPerQuad)];
  int sideQuads = 4 * int(kBarPieces);
  if (quad < sideQuads) {
    return BarCorner(quad / 4 + corner.x, (quad % 4 + corner.y) % 4, quad % 4);
  }
  bool atEnd = quad > sideQuads;
  int around = corner.x == 0 ? corner.y : 3 - corner.y;
  return BarCorner(atEnd ? int(kBarPieces) : 0, atEnd ? around : 3 - around, atEnd ? 5 : 4);
}

vec3 normalOf(Section section, int side) {
  vec3 outwards[6] = vec3[](-section.b, section.n, section.b, -section.n, -section.along,
                            section.along);
  return outwards[side];
}

Strut placeCorner() {
  Strut strut = strutAt(gl_VertexIndex / int(kVerticesPerBar));
  BarCorner corner = cornerOf(gl_VertexIndex % int(kVerticesPerBar));
  Section section = sectionAt(strut, corner.section);
  float least = kLeastHalfWidth * pixelSizeAt(section.centre);
  vec2 halves = max(vec2(push.halfWidth, push.halfHeight), least);
  vec2 signs = kSection[corner.corner];
  vec3 outline =
      section.centre + halves.x * signs.x * section.n + halves.y * signs.y * section.b;
  normal = normalOf(section, corner.side);
  towardsEye = push.eye - outline;
  pixels = min(halves.x, halves.y) / pixelSizeAt(section.centre);
  gl_Position = push.clipFromLocal * vec4(outline, 1);
  float nearer = kPrecedence * push.halfWidth * float(2 - push.direction);
  vec4 shifted = push.clipFromLocal * vec4(outline + nearer * normalize(towardsEye), 1);
  gl_Position.z = shifted.z / shifted.w * gl_Position.w;
  return strut;
}

void main() { show(placeCorner()); }
