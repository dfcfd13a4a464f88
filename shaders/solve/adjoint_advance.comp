// A step of conjugate gradients along a direction p: solution + step p, residual - step A p.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/adjoint_types.h"

layout(local_size_x = kVectorInvocations) in;

layout(binding = kBindingFirst, rgba32f) readonly uniform imageBuffer direction;
layout(binding = kBindingSecond, rgba32f) readonly uniform imageBuffer productOfDirection;
layout(std430, binding = kBindingSolution) buffer Solution { vec4 solution[]; };
layout(std430, binding = kBindingRemainder) buffer Remainder { vec4 remainder[]; };
layout(std430, binding = kBindingScalars) readonly buffer Scalars { ConjugateScalars scalars; };
layout(push_constant) uniform Push { AdvancePush push; };

void main() {
  uint n = gl_GlobalInvocationID.x;
  if (n < push.count) {
    solution[n] += scalars.step * imageLoad(direction, int(n));
    remainder[n] -= scalars.step * imageLoad(productOfDirection, int(n));
  }
}
