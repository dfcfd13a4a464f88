// A rod or a ball that was drawn flat, facing the eye: shaded as if it were round.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/render_types.h"

layout(push_constant) uniform Push { SamplingPush push; };

layout(location = 0) flat in vec3 base;
layout(location = 1) in vec2 offset;  // Within the unit circle, from the middle.
layout(location = 2) in vec3 right;   // Where offset.x grows.
layout(location = 3) in vec3 up;      // Where offset.y grows.
layout(location = 4) in vec3 facing;  // Towards the eye.

layout(location = 0) out vec4 color;

void main() {
  float height = sqrt(max(1 - dot(offset, offset), 0));
  vec3 normal = normalize(offset.x * right + offset.y * up + height * facing);
  float lit = max(dot(normal, push.towardsLight), 0);
  float highlight = pow(lit, 20);
  color = vec4(base * (0.66 + 0.42 * lit) + 0.18 * highlight, 1);
}
