// Adds a coarse level's motions to those of the level above.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "shared/multigrid_types.h"
#include "solve/interpolation.glsl"
#include "solve/point_rows.glsl"

layout(local_size_x_id = kConstantSubgroupSize) in;

layout(binding = kBindingCoarseVector, rgba32f) readonly uniform imageBuffer coarseVector;
// One buffer twice: loads of texels are the faster ones.
layout(binding = kBindingFineVector, rgba32f) readonly uniform imageBuffer fineVector;
layout(std430, binding = kBindingFineResult) writeonly buffer FineResult { vec4 fineResult[]; };

void main() {
  ivec2 p = pointOf(push.firstRow);
  if (!hasPoint(push.fineSize, p)) {
    return;
  }
  Motion x = MOTION_AT(fineVector, fineIndex(p));
  [[unroll]] for (int v = 0; v < 2; ++v) {
    [[unroll]] for (int u = 0; u < 2; ++u) {
      ivec2 coarse = firstCoarse(p) + ivec2(u, v);
      Motion c = MOTION_AT(coarseVector, coarseIndex(coarse));
      x = sum(x, interpolated(interpolationOf(p, coarse), c));
    }
  }
  STORE_MOTION(fineResult, writtenIndex(push.fineSize), x);
}
