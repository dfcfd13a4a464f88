// A smooth surface coloured by shares; the light is mild, so that colours can be read.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "render/surface_light.glsl"
#include "shared/share_color.h"

layout(location = 3) centroid in float share;

layout(location = 0) out vec4 color;

void main() {
  vec3 lit = shareColor(share) * (0.72 + 0.28 * lightHere().diffuse);
  color = vec4(mix(lit, kInk, lineCoverage()), 1);
}
