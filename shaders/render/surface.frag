// A smooth surface with isolines, of two colours or, with kShowsShares, coloured by shares.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "render/surface_light.glsl"
#include "shared/share_color.h"

layout(constant_id = kConstantShowsShares) const bool kShowsShares = false;

layout(location = 3) centroid in float share;

layout(location = 0) out vec4 color;

const vec3 kFront = vec3(0.72, 0.80, 0.90);
const vec3 kBack = vec3(0.90, 0.80, 0.70);

vec3 litSides(Light light) {
  return (light.front ? kFront : kBack) * (0.38 + 0.66 * light.diffuse) + 0.10 * light.highlight;
}

// The light is mild, so that colours can be read.
vec3 litShare(Light light) { return shareColor(share) * (0.72 + 0.28 * light.diffuse); }

void main() {
  Light light = lightHere();
  vec3 lit = kShowsShares ? litShare(light) : litSides(light);
  color = vec4(mix(lit, kInk, lineCoverage()), 1);
}
