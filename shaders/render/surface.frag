// A smooth surface, lit from both sides, with faint isolines along the struts.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/render_types.h"

layout(push_constant) uniform Push { SurfacePush push; };

layout(location = 0) centroid in vec3 point;
layout(location = 1) centroid in vec3 normal;
layout(location = 2) in vec2 parameter;

layout(location = 0) out vec4 color;

const vec3 kFront = vec3(0.72, 0.80, 0.90);
const vec3 kBack = vec3(0.90, 0.80, 0.70);
const float kIsolineHalfWidth = 0.5;  // Pixels.
const float kBorderHalfWidth = 1.0;
const float kFewestPixels = 5;  // Isolines closer than this would only grey the surface.

// How much of the pixel a line at `distance` pixels covers.
float coverage(float distance, float halfWidth) {
  return clamp(halfWidth + 0.5 - distance, 0, 1);
}

float isolineCoverage(vec2 pixelStep) {
  vec2 stride = vec2(push.isolineStride);
  vec2 nearest = abs(fract(parameter / stride + 0.5) - 0.5) * stride / pixelStep;
  vec2 room = clamp(stride / pixelStep / kFewestPixels - 1, 0, 1);
  return max(coverage(nearest.x, kIsolineHalfWidth) * room.x,
             coverage(nearest.y, kIsolineHalfWidth) * room.y);
}

float borderCoverage(vec2 pixelStep) {
  // Negative where the pixel's centre lies outside.
  vec2 last = vec2(push.verticesU, push.verticesV) - 1;
  vec2 nearest = min(parameter, last - parameter) / pixelStep;
  return coverage(min(nearest.x, nearest.y), kBorderHalfWidth);
}

void main() {
  vec2 dx = dFdx(parameter), dy = dFdy(parameter);
  vec2 pixelStep = max(sqrt(dx * dx + dy * dy), vec2(1e-6));
  vec3 towardsEye = normalize(push.eye - point);
  vec3 flatNormal = cross(dFdx(point), dFdy(point));

  vec3 n = dot(normal, normal) > 0.01 ? normalize(normal) : normalize(flatNormal);
  bool front = dot(n, towardsEye) > 0;
  n = front ? n : -n;
  float diffuse = 0.5 + 0.5 * dot(n, push.towardsLight);
  float highlight = pow(max(dot(n, normalize(push.towardsLight + towardsEye)), 0), 40);
  vec3 lit = (front ? kFront : kBack) * (0.38 + 0.66 * diffuse) + 0.10 * highlight;

  float lines = max(0.28 * isolineCoverage(pixelStep), 0.65 * borderCoverage(pixelStep));
  color = vec4(mix(lit, vec3(0.12, 0.15, 0.20), lines), 1);
}
