// A linear combination of vectors, and its largest step: either loop of L-BFGS's recursion. Turns count as moves
// by kMovePerTurn.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/lbfgs_types.h"

layout(local_size_x = kVectorInvocations) in;

layout(binding = kBindingBase, rgba32f) readonly uniform imageBuffer base;
layout(binding = kBindingSteps, rgba32f) readonly uniform imageBuffer first;
layout(binding = kBindingSteps + 1, rgba32f) readonly uniform imageBuffer second;
layout(binding = kBindingSteps + 2, rgba32f) readonly uniform imageBuffer third;
layout(std430, binding = kBindingOutput) writeonly buffer Output { vec4 result[]; };
layout(std430, binding = kBindingReduced) writeonly buffer Reduced { float largest[]; };
layout(push_constant) uniform Push { CombinePush push; };

shared float squares[kVectorInvocations];

void main() {
  float square = 0.0;
  for (uint n = gl_GlobalInvocationID.x; n < push.count; n += push.stride) {
    int v = int(n);
    vec4 sum = imageLoad(base, v) + push.weights[0] * imageLoad(first, v) +
               push.weights[1] * imageLoad(second, v) + push.weights[2] * imageLoad(third, v);
    result[n] = sum;
    float scale = n < push.vertices ? 1.0 : kMovePerTurn;
    square = max(square, scale * scale * dot(sum, sum));
  }
  uint lane = gl_LocalInvocationIndex;
  squares[lane] = square;
  for (uint reach = kVectorInvocations / 2u; reach > 0u; reach /= 2u) {
    barrier();
    if (lane < reach) {
      squares[lane] = max(squares[lane], squares[lane + reach]);
    }
  }
  if (lane == 0u) {
    largest[gl_WorkGroupID.x] = sqrt(squares[0]);
  }
}
