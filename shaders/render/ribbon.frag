// Shades a ribbon like a rod; keeps the hue.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "render/strut_paint.glsl"

layout(push_constant) uniform Push { StrutPush push; };

layout(location = 1) in float across;
layout(location = 2) in vec3 side;
layout(location = 3) in vec3 facing;
layout(location = 4) in float pixels;
layout(location = 5) in vec2 fromEnds;

void main() {
  float t = clamp(across, -1, 1);
  vec3 normal = normalize(t * side + sqrt(1 - t * t) * facing);
  float lit = 0.62 + 0.38 * dot(normal, push.towardsLight);
  // Rods that meet melt into each other.
  float apart = smoothstep(0.5, 2.0, min(fromEnds.x, fromEnds.y));
  float rim = 1 - 0.45 * apart * t * t * t * t;
  // A rod of few pixels has no room for shading: there it would only darken the colour.
  paint(mix(0.9, lit * rim, smoothstep(0.75, 2.5, pixels)));
}
