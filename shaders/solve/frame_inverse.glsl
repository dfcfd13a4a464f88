// D^-1 of a frame, a block of 6 x 6 a joint, and what a smoothing step makes of a right side with it.
#include "shared/frame_types.h"
#include "solve/block.glsl"

layout(local_size_x = kVertexInvocations) in;

layout(binding = kBindingRightSide, rgba32f) readonly uniform imageBuffer rightSide;
layout(binding = kBindingInverse + 0u, rgba32f) readonly uniform imageBuffer inverse0;
layout(binding = kBindingInverse + 1u, rgba32f) readonly uniform imageBuffer inverse1;
layout(binding = kBindingInverse + 2u, rgba32f) readonly uniform imageBuffer inverse2;
layout(std430, binding = kBindingResult) writeonly buffer Result { vec4 result[]; };
layout(push_constant) uniform Push { FramePush push; };

int layerLength() { return push.grid.size.x * push.grid.size.y; }

int jointCount() { return layerLength() * push.grid.size.z; }

bool isOwned() { return int(gl_GlobalInvocationID.x) < layerLength(); }

// Without a branch: the last one of the layer for those beyond.
int jointOfInvocation() {
  return int(gl_GlobalInvocationID.y) * layerLength() +
         min(int(gl_GlobalInvocationID.x), layerLength() - 1);
}

Motion smoothingStep(int index) {
  Motion b = Motion(imageLoad(rightSide, index).xyz, imageLoad(rightSide, jointCount() + index).xyz);
  Motion step = multiply(BLOCK_AT(inverse0, inverse1, inverse2, index), b);
  return Motion(push.weight * step.t, push.weight * step.w);
}
