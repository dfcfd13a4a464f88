// first . second and first . first, a part of the sums per workgroup.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/adjoint_types.h"

layout(local_size_x = kVectorInvocations) in;

layout(binding = kBindingFirst, rgba32f) readonly uniform imageBuffer first;
layout(binding = kBindingSecond, rgba32f) readonly uniform imageBuffer second;
layout(std430, binding = kBindingProducts) writeonly buffer Products { vec2 products[]; };
layout(push_constant) uniform Push { DotsPush push; };

shared vec2 sums[kVectorInvocations];

void main() {
  vec2 sum = vec2(0);
  for (uint n = gl_GlobalInvocationID.x; n < push.count; n += push.stride) {
    vec3 a = imageLoad(first, int(n)).xyz;
    vec3 b = imageLoad(second, int(n)).xyz;
    sum += vec2(dot(a, b), dot(a, a));
  }
  // Pairwise: accurate and the same in every run.
  uint lane = gl_LocalInvocationIndex;
  sums[lane] = sum;
  for (uint reach = kVectorInvocations / 2u; reach > 0u; reach /= 2u) {
    barrier();
    if (lane < reach) {
      sums[lane] += sums[lane + reach];
    }
  }
  if (lane == 0u) {
    products[gl_WorkGroupID.x] = sums[0];
  }
}
