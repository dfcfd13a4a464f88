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
layout(std430, binding = kBindingReduced) writeonly buffer Reduced { PairDots reduced[]; };
layout(push_constant) uniform Push { DotsPush push; };

shared PairDots sums[kVectorInvocations];

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
  // Pairwise: accurate and the same in every run.
  uint lane = gl_LocalInvocationIndex;
  sums[lane] = sum;
  for (uint reach = kVectorInvocations / 2u; reach > 0u; reach /= 2u) {
    barrier();
    if (lane < reach) {
      sums[lane].gradient += sums[lane + reach].gradient;
      sums[lane].correction += sums[lane + reach].correction;
      sums[lane].changes[0] += sums[lane + reach].changes[0];
      sums[lane].changes[1] += sums[lane + reach].changes[1];
      sums[lane].changes[2] += sums[lane + reach].changes[2];
    }
  }
  if (lane == 0u) {
    reduced[gl_WorkGroupID.x] = sums[0];
  }
}
