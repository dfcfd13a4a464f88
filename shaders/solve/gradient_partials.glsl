// What a workgroup's invocations have added up, Sum energy and Sum squaredGradient: pairwise sums, accurate
// and the same in every run.
#include "solve/float_pairs.glsl"

layout(std430, binding = kBindingPartials) writeonly buffer Partials { vec4 partials[]; };

shared vec4 sums[kLargestSubgroup];

Sum squaredGradient = Sum(0);

vec2 pairOf(Sum sum) {
  float high = float(sum);
  return vec2(high, float(sum - Sum(high)));
}

void writePartials() {
  uint lane = gl_LocalInvocationIndex;
  sums[lane] = vec4(pairOf(energy), pairOf(squaredGradient));
  for (uint stride = gl_WorkGroupSize.x / 2u; stride > 0u; stride /= 2u) {
    barrier();
    if (lane < stride) {
      sums[lane] = pairSums(sums[lane], sums[lane + stride]);
    }
  }
  if (lane == 0u) {
    partials[gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x] = sums[0];
  }
}
