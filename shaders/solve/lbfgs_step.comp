// A step downhill: trial positions, and rotations.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/lbfgs_types.h"
#include "energy/arm.glsl"
#include "energy/turn.glsl"

layout(local_size_x = kVectorInvocations) in;

layout(binding = kBindingFrom, rgba32i) readonly uniform iimageBuffer positions;
layout(binding = kBindingBase, rgba32f) readonly uniform imageBuffer direction;
layout(std430, binding = kBindingOutput) writeonly buffer Output { ivec4 trial[]; };
layout(push_constant) uniform Push { StepPush push; };

void main() {
  uint n = gl_GlobalInvocationID.x;
  if (n < push.count) {
    vec3 change = -push.share * imageLoad(direction, int(n)).xyz;
    ivec4 now = imageLoad(positions, int(n));
    trial[n] = n < push.vertices ? moved(now, change / push.resolution) : turned(now, change);
  }
}
