// What a step taken tells L-BFGS: s, the change of the positions, and y, that of the gradient.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/lbfgs_types.h"
#include "energy/arm.glsl"
#include "energy/turn.glsl"

layout(local_size_x = kVectorInvocations) in;

layout(binding = kBindingFrom, rgba32i) readonly uniform iimageBuffer from;
layout(binding = kBindingTo, rgba32i) readonly uniform iimageBuffer to;
layout(binding = kBindingBase, rgba32f) readonly uniform imageBuffer gradientBefore;
layout(binding = kBindingGradient, rgba32f) readonly uniform imageBuffer gradientAfter;
layout(std430, binding = kBindingOutput) writeonly buffer Output { vec4 taken[]; };
layout(std430, binding = kBindingOutput2) writeonly buffer Output2 { vec4 change[]; };
layout(push_constant) uniform Push { StepPush push; };

void main() {
  uint n = gl_GlobalInvocationID.x;
  if (n < push.count) {
    int v = int(n);
    ivec4 before = imageLoad(from, v), after = imageLoad(to, v);
    taken[n] = vec4(n < push.vertices ? stepsBetween(before, after) * push.resolution
                                      : turnBetween(before, after), 0.0);
    change[n] = imageLoad(gradientAfter, v) - imageLoad(gradientBefore, v);
  }
}
