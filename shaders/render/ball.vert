// Where a ray hit, or missed, as a ball: a disc that faces the eye, shaded like a ball.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/render_types.h"

layout(binding = kBindingBalls) readonly buffer Balls { vec4 balls[]; };
layout(push_constant) uniform Push { SamplingPush push; };

layout(location = 0) flat out vec3 base;
layout(location = 1) out vec2 offset;
layout(location = 2) out vec3 right;
layout(location = 3) out vec3 up;
layout(location = 4) out vec3 facing;

const vec3 kHit = vec3(0.20, 0.21, 0.23);
const vec3 kMissed = vec3(1.00, 0.56, 0.05);
const float kLeastRadius = 1;         // Pixels.
const float kLeastMissedRadius = 2;  // A hole must be seen.

// On the unit circle, or its centre.
vec2 cornerOfFan(int vertex) {
  float angle = 6.28318530718 / float(kDiscSides) * float(vertex / 3 + vertex % 3);
  return vertex % 3 == 0 ? vec2(0) : vec2(cos(angle), sin(angle));
}

void main() {
  vec4 ball = balls[gl_VertexIndex / int(kVerticesPerDisc)];
  bool missed = ball.w == 0;
  vec3 towardsEye = push.eye - ball.xyz;
  facing = normalize(towardsEye);
  right = normalize(cross(abs(facing.y) < 0.9 ? vec3(0, 1, 0) : vec3(1, 0, 0), facing));
  up = cross(facing, right);
  offset = cornerOfFan(gl_VertexIndex % int(kVerticesPerDisc));
  base = missed ? kMissed : kHit;
  float leastPixels = missed ? kLeastMissedRadius : kLeastRadius;
  float radius = max(push.radius, leastPixels * push.pixelSize * length(towardsEye));
  vec3 outline = ball.xyz + push.lift * facing + radius * (offset.x * right + offset.y * up);
  gl_Position = push.clipFromLocal * vec4(outline, 1);
  if (missed) {
    gl_Position.z = 0;  // Nothing hides a hole.
  }
}
