// Rotations as quaternions in fixed point (shared/frame_types.h), whose length is 1 but for rounding.
#ifndef MORPHGRID_ENERGY_TURN
#define MORPHGRID_ENERGY_TURN
#include "shared/frame_types.h"

const float kRotationSteps = float(1 << int(kRotationBits));

vec4 quaternionOf(ivec4 rotation) { return vec4(rotation) / kRotationSteps; }

// Where a joint is once it has turned further, by and about the vector `turn` in space. What is added is small
// where the turn is, and the sum one of integers.
ivec4 turned(ivec4 rotation, vec3 turn) {
  vec4 q = quaternionOf(rotation);
  float halfAngle = 0.5 * length(turn);
  float share = halfAngle > 1e-4 ? sin(halfAngle) / halfAngle : 1.0 - halfAngle * halfAngle / 6.0;
  vec3 v = 0.5 * share * turn;
  float s = sin(0.5 * halfAngle);
  float w = -2.0 * s * s;  // cos(halfAngle) - 1
  vec4 change = vec4(w * q.xyz + q.w * v + cross(v, q.xyz), w * q.w - dot(v, q.xyz));
  change += 0.5 * (1.0 - dot(q, q)) * q;
  return rotation + ivec4(round(change * kRotationSteps));
}

// The turn that leads from one to the other, where it is small.
vec3 turnBetween(ivec4 from, ivec4 to) {
  vec4 q = quaternionOf(from);
  vec4 change = vec4(to - from) / kRotationSteps;
  return 2.0 * (q.w * change.xyz - change.w * q.xyz - cross(change.xyz, q.xyz));
}
#endif
