// All dot products that L-BFGS needs of its vectors, in one pass.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/lbfgs_types.h"

layout(local_size_x = kVectorInvocations) in;

layout(binding = kBindingSteps, rgba32f) readonly uniform imageBuffer s0;
layout(binding = kBindingSteps + 1, rgba32f) readonly uniform imageBuffer s1;
layout(binding = kBindingSteps + 2, rgba32f) readonly uniform imageBuffer s2;
layout(binding = kBindingChanges, rgba32f) readonly uniform imageBuffer y0;
layout(binding = kBindingChanges + 1, rgba32f) readonly uniform imageBuffer y1;
layout(binding = kBindingChanges + 2, rgba32f) readonly uniform imageBuffer y2;
layout(binding = kBindingGradient, rgba32f) readonly uniform imageBuffer gradient;
layout(binding = kBindingCorrection, rgba32f) readonly uniform imageBuffer correction;
layout(std430, binding = kBindingReduced) writeonly buffer Reduced { float reduced[]; };  // PairDots
layout(push_constant) uniform Push { DotsPush push; };

const uint kSums = 20u;  // Floats in PairDots.
shared float sums[kSums][kVectorInvocations];

void store(uint first, vec4 sum) {
  for (uint n = 0u; n < 4u; ++n) {
    sums[first + n][gl_LocalInvocationIndex] = sum[n];
  }
}

void main() {
  PairDots sum = PairDots(vec4(0), vec4(0), vec4[](vec4(0), vec4(0), vec4(0)));
  for (uint n = gl_GlobalInvocationID.x; n < push.count; n += push.stride) {
    int v = int(n);
    mat3 s = mat3(imageLoad(s0, v).xyz, imageLoad(s1, v).xyz, imageLoad(s2, v).xyz);
    mat3 y = mat3(imageLoad(y0, v).xyz, imageLoad(y1, v).xyz, imageLoad(y2, v).xyz);
    vec3 g = imageLoad(gradient, v).xyz;
    vec3 z = imageLoad(correction, v).xyz;
    sum.gradient += vec4(g * s, dot(z, g));
    sum.correction += vec4(z * y, 0.0);
    sum.changes[0] += vec4(s[0] * y, 0.0);
    sum.changes[1] += vec4(s[1] * y, 0.0);
    sum.changes[2] += vec4(s[2] * y, 0.0);
  }
  store(0u, sum.gradient);
  store(4u, sum.correction);
  store(8u, sum.changes[0]);
  store(12u, sum.changes[1]);
  store(16u, sum.changes[2]);
  barrier();
  // An invocation a sum, in a fixed order: on lavapipe a tree of barriers costs more than all the rest.
  uint which = gl_LocalInvocationIndex;
  if (which < kSums) {
    float total = 0.0;
    for (uint n = 0u; n < kVectorInvocations; ++n) {
      total += sums[which][n];
    }
    reduced[gl_WorkGroupID.x * kSums + which] = total;
  }
}
