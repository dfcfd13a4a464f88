// A surface that others are seen through.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "render/surface_light.glsl"

layout(location = 0) out vec4 color;

const vec3 kVeil = vec3(0.45, 0.50, 0.60);
const float kOpacity = 0.17;

void main() {
  float lines = lineCoverage();
  vec3 lit = kVeil * (0.4 + 0.8 * lightHere().diffuse);
  color = vec4(mix(lit, kInk, lines), mix(kOpacity, 1, lines));
}
