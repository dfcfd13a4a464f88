// Light from both sides, and faint isolines along the struts.
#include "shared/render_types.h"

layout(push_constant) uniform Push { SurfacePush push; };

layout(location = 0) centroid in vec3 point;
layout(location = 1) centroid in vec3 normal;
layout(location = 2) in vec2 parameter;

const vec3 kInk = vec3(0.12, 0.15, 0.20);
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
  vec2 last = vec2(push.drawnSize - 1);
  vec2 nearest = min(parameter, last - parameter) / pixelStep;
  return coverage(min(nearest.x, nearest.y), kBorderHalfWidth);
}

// How much of the pixel isolines and borders cover.
float lineCoverage() {
  vec2 dx = dFdx(parameter), dy = dFdy(parameter);
  vec2 pixelStep = max(sqrt(dx * dx + dy * dy), vec2(1e-6));
  return max(0.28 * isolineCoverage(pixelStep), 0.65 * borderCoverage(pixelStep));
}

struct Light {
  bool front;  // The eye sees the side that the normal points to.
  float diffuse;
  float highlight;
};

Light lightHere() {
  vec3 towardsEye = normalize(push.eye - point);
  vec3 flatNormal = cross(dFdx(point), dFdy(point));
  vec3 n = dot(normal, normal) > 0.01 ? normalize(normal) : normalize(flatNormal);
  bool front = dot(n, towardsEye) > 0;
  n = front ? n : -n;
  return Light(front, 0.5 + 0.5 * dot(n, push.towardsLight),
               pow(max(dot(n, normalize(push.towardsLight + towardsEye)), 0), 40));
}
