// The next direction of conjugate gradients: the preconditioned residual + turn x the last one.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/adjoint_types.h"

layout(local_size_x = kVectorInvocations) in;

layout(binding = kBindingFirst, rgba32f) readonly uniform imageBuffer correction;
layout(std430, binding = kBindingSolution) buffer Direction { vec4 direction[]; };
layout(std430, binding = kBindingScalars) readonly buffer Scalars { ConjugateScalars scalars; };
layout(push_constant) uniform Push { AdvancePush push; };

void main() {
  uint n = gl_GlobalInvocationID.x;
  if (n < push.count) {
    direction[n] = imageLoad(correction, int(n)) + scalars.turn * direction[n];
  }
}
