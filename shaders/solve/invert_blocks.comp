// D^-1: the inverses of the blocks of 6 x 6 on a coarse level's diagonal, quarter by quarter.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "shared/multigrid_types.h"
#include "solve/block_inverse.glsl"
#include "solve/point_rows.glsl"

layout(local_size_x_id = kConstantSubgroupSize) in;

layout(binding = kBindingMatrix + 0u, rgba32f) readonly uniform imageBuffer self0;
layout(binding = kBindingMatrix + 1u, rgba32f) readonly uniform imageBuffer self1;
layout(binding = kBindingMatrix + 2u, rgba32f) readonly uniform imageBuffer self2;
layout(std430, binding = kBindingInverse + 0u) writeonly buffer Inverse0 { vec4 inverse0[]; };
layout(std430, binding = kBindingInverse + 1u) writeonly buffer Inverse1 { vec4 inverse1[]; };
layout(std430, binding = kBindingInverse + 2u) writeonly buffer Inverse2 { vec4 inverse2[]; };
layout(push_constant) uniform Push { SmoothingPush push; };

void main() {
  ivec2 p = pointOf(push.firstRow);
  if (!hasPoint(push.size, p)) {
    return;
  }
  int point = pointIndex(push.size, p);
  Block a = BLOCK_AT(self0, self1, self2, point);
  Block inverse = inverseOf(a);
  STORE_BLOCK(inverse0, inverse1, inverse2, writtenIndex(push.size), inverse);
}
