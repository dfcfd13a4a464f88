// A step of block-Jacobi on a coarse level, from zero: omega D^-1 b.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "shared/multigrid_types.h"
#include "solve/block.glsl"
#include "solve/point_rows.glsl"

layout(local_size_x_id = kConstantSubgroupSize) in;

layout(binding = kBindingInverse + 0u, rgba32f) readonly uniform imageBuffer inverse0;
layout(binding = kBindingInverse + 1u, rgba32f) readonly uniform imageBuffer inverse1;
layout(binding = kBindingInverse + 2u, rgba32f) readonly uniform imageBuffer inverse2;
layout(binding = kBindingRightSide, rgba32f) readonly uniform imageBuffer rightSide;
layout(std430, binding = kBindingResult) writeonly buffer Result { vec4 result[]; };
layout(push_constant) uniform Push { SmoothingPush push; };

void main() {
  ivec2 p = pointOf(push.firstRow);
  if (!hasPoint(push.size, p)) {
    return;
  }
  int point = pointIndex(push.size, p);
  Motion step = multiply(BLOCK_AT(inverse0, inverse1, inverse2, point), MOTION_AT(rightSide, point));
  STORE_MOTION(result, writtenIndex(push.size),
               Motion(push.weight * step.t, push.weight * step.w));
}
