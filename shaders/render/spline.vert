// The Catmull-Rom splines through rays' hits, along u or v, as ribbons that face the eye: two triangles
// of a piece. Missed rays interrupt them.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/render_types.h"
#include "render/catmull_rom.glsl"

layout(binding = kBindingRayHits) readonly buffer RayHits { vec4 hits[]; };
layout(push_constant) uniform Push { SamplingPush push; };

layout(location = 0) flat out vec3 base;
layout(location = 1) out vec2 offset;
layout(location = 2) out vec3 right;
layout(location = 3) out vec3 up;
layout(location = 4) out vec3 facing;

// Corners of two triangles: x along the piece, y across it.
const vec2 kCorners[kVerticesPerQuad] =
    vec2[](vec2(0, -1), vec2(1, -1), vec2(1, 1), vec2(0, -1), vec2(1, 1), vec2(0, 1));

const vec3 kRed = vec3(0.84, 0.10, 0.11);
const vec3 kBlue = vec3(0.12, 0.27, 0.82);
const float kLeastHalfWidth = 0.6;  // Pixels: anything thinner breaks up.

// The hit of a ray of an isoline; w is 0 where it missed or there is none.
vec4 hitAt(int ray, int isoline) {
  bool alongU = push.direction == 0;
  int count = alongU ? push.countU : push.countV;
  if (ray < 0 || ray >= count) {
    return vec4(0);
  }
  return alongU ? hits[isoline * push.countU + ray] : hits[ray * push.countU + isoline];
}

// Beyond an end of a spline there is no point: the parabola through the last three stands in.
vec4 extrapolated(vec4 third, vec4 second, vec4 last) {
  vec3 beyond = third.w > 0 ? 3 * last.xyz - 3 * second.xyz + third.xyz : 2 * last.xyz - second.xyz;
  return vec4(beyond, 1);
}

// Columns: the points before, at, after and beyond the ends of the segment that begins at a ray.
mat4 pointsAround(int ray, int isoline) {
  mat4 points = mat4(hitAt(ray - 1, isoline), hitAt(ray, isoline), hitAt(ray + 1, isoline),
                     hitAt(ray + 2, isoline));
  vec4 before = points[0].w > 0 ? points[0] : extrapolated(points[3], points[2], points[1]);
  vec4 beyond = points[3].w > 0 ? points[3] : extrapolated(points[0], points[1], points[2]);
  return mat4(before, points[1], points[2], beyond);
}

void main() {
  bool alongU = push.direction == 0;
  int pieces = ((alongU ? push.countU : push.countV) - 1) * push.refine;
  int stride = alongU ? push.strideV : push.strideU;
  int lastIsoline = (alongU ? push.countV : push.countU) - 1;
  int piece = gl_VertexIndex / int(kVerticesPerQuad);
  int isoline = min(piece / pieces * stride, lastIsoline);
  int ray = piece % pieces / push.refine;
  vec2 corner = kCorners[gl_VertexIndex % int(kVerticesPerQuad)];
  float t = (float(piece % push.refine) + corner.x) / float(push.refine);

  mat4 points = pointsAround(ray, isoline);
  vec3 point = (points * pointWeights(t)).xyz;
  vec3 tangent = (points * tangentWeights(t)).xyz;
  vec3 towardsEye = push.eye - point;
  facing = normalize(towardsEye);
  vec3 sideways = cross(tangent, facing);
  right = sideways / max(length(sideways), 1e-20);
  up = vec3(0);  // A rod bends the light in one direction.
  offset = vec2(corner.y, 0);
  base = alongU ? kRed : kBlue;
  float halfWidth = max(push.radius, kLeastHalfWidth * push.pixelSize * length(towardsEye));
  vec3 outline = point + push.lift * facing + corner.y * halfWidth * right;
  bool present = points[1].w > 0 && points[2].w > 0;
  gl_Position = present ? push.clipFromLocal * vec4(outline, 1) : vec4(0, 0, 2, 1);  // Clipped.
}
