// A smooth surface with isolines: of two colours, coloured by shares, or a veil that others are seen
// through.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "render/surface_light.glsl"
#include "shared/share_color.h"

layout(constant_id = kConstantShowsShares) const bool kShowsShares = false;
layout(constant_id = kConstantIsVeil) const bool kIsVeil = false;

layout(location = 3) centroid in float share;

layout(location = 0) out vec4 color;

const vec3 kFront = vec3(0.72, 0.80, 0.90);
const vec3 kBack = vec3(0.90, 0.80, 0.70);
const vec3 kVeil = vec3(0.45, 0.50, 0.60);
const float kVeilOpacity = 0.17;

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
