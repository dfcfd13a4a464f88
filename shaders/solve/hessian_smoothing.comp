// z' = z + omega D^-1 r: a step of block-Jacobi smoothing, r = b - H z the residual.
#version 450
#extension GL_GOOGLE_include_directive : require
#include "shared/hessian_types.h"
#include "solve/inverse_blocks.glsl"

layout(local_size_x = kVertexInvocations) in;

layout(binding = kBindingVector, rgba32f) readonly uniform imageBuffer vectors;
layout(binding = kBindingRightSide, rgba32f) readonly uniform imageBuffer rightSide;
layout(std430, binding = kBindingResult) writeonly buffer Result { vec4 result[]; };
layout(push_constant) uniform Push { HessianPush push; };

void main() {
  int layerLength = push.grid.size.x * push.grid.size.y;
  int inLayer = int(gl_GlobalInvocationID.x);
  int index = int(gl_GlobalInvocationID.y) * layerLength + min(inLayer, layerLength - 1);
  vec3 step = push.weight * multiplyInverse(index, imageLoad(rightSide, index).xyz);
  if (inLayer < layerLength) {
    result[index] = vec4(imageLoad(vectors, index).xyz + step, 0.0);
  }
}
