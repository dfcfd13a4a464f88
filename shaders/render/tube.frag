// Light on a tube; keeps the hue.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "render/strut_paint.glsl"

layout(push_constant) uniform Push { StrutPush push; };

layout(location = 1) in vec3 normal;
layout(location = 2) in vec3 towardsEye;
layout(location = 3) in float pixels;

void main() {
  vec3 n = normalize(normal);
  float facing = dot(n, normalize(towardsEye));
  float lit = 0.62 + 0.38 * dot(n, push.towardsLight);
  float edge = 1 - facing * facing;
  float rim = 1 - 0.45 * edge * edge;
  // A tube of few pixels has no room for shading: there it would only darken the colour.
  paint(mix(0.9, lit * rim, smoothstep(0.75, 2.5, pixels)));
}
