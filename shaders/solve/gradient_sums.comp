// Adds up the partial sums of the gradient's workgroups: energy and |g|^2, pairs of floats.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/hessian_types.h"
#include "solve/float_pairs.glsl"

layout(local_size_x = kReductionInvocations) in;

layout(std430, binding = kBindingPartials) readonly buffer Partials { vec4 partials[]; };
layout(std430, binding = kBindingSums) writeonly buffer Sums { vec4 total; };
layout(push_constant) uniform Push { ReductionPush push; };

shared vec4 sums[kReductionInvocations];

void main() {
  uint lane = gl_LocalInvocationIndex;
  vec4 sum = vec4(0);
  for (uint n = lane; n < push.count; n += kReductionInvocations) {
    sum = pairSums(sum, partials[n]);
  }
  sums[lane] = sum;
  for (uint stride = kReductionInvocations / 2u; stride > 0u; stride /= 2u) {
    barrier();
    if (lane < stride) {
      sums[lane] = pairSums(sums[lane], sums[lane + stride]);
    }
  }
  if (lane == 0u) {
    total = sums[0];
  }
}
