// A smooth surface with isolines: of two colours, coloured by shares, or a veil that others are seen
// through.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/render_types.h"
#include "shared/share_color.h"

layout(constant_id = kConstantShowsShares) const bool kShowsShares = false;
layout(constant_id = kConstantIsVeil) const bool kIsVeil = false;

layout(push_constant) uniform Push { SurfacePush push; };

layout(location = 0) centroid in vec3 point;
layout(location = 1) centroid in vec3 normal;
layout(location = 2) in vec2 parameter;
layout(location = 3) centroid in float share;

layout(location = 0) out vec4 color;

const vec3 kFront = vec3(0.72, 0.80, 0.90);
const vec3 kBack = vec3(0.90, 0.80, 0.70);
const vec3 kVeil = vec3(0.45, 0.50, 0.60);
const float kVeilOpacity = 0.17;
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

vec3 litSides(Light light) {
  return (light.front ? kFront : kBack) * (0.38 + 0.66 * light.diffuse) + 0.10 * light.highlight;
}

// The light is mild, so that colours can be read.
vec3 litShare(Light light) { return shareColor(share) * (0.72 + 0.28 * light.diffuse); }

vec3 litVeil(Light light) { return kVeil * (0.4 + 0.8 * light.diffuse); }

void main() {
  Light light = lightHere();
  float lines = lineCoverage();
  vec3 lit = kIsVeil ? litVeil(light) : kShowsShares ? litShare(light) : litSides(light);
  float opacity = kIsVeil ? mix(kVeilOpacity, 1, lines) : 1;
  color = vec4(mix(lit, kInk, lines), opacity);
}
