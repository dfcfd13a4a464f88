// A smooth surface of two colours, with isolines.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "render/surface_light.glsl"

layout(location = 0) out vec4 color;

const vec3 kFront = vec3(0.72, 0.80, 0.90);
const vec3 kBack = vec3(0.90, 0.80, 0.70);

void main() {
  Light light = lightHere();
  vec3 lit = (light.front ? kFront : kBack) * (0.38 + 0.66 * light.diffuse) + 0.10 * light.highlight;
  color = vec4(mix(lit, kInk, lineCoverage()), 1);
}
