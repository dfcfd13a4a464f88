// Adds a coarse level's motions to those of the level above.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "shared/multigrid_types.h"
#include "solve/block.glsl"
#include "solve/point_rows.glsl"
#include "solve/transfer.glsl"

layout(local_size_x_id = kConstantSubgroupSize) in;

layout(binding = kBindingCoarseVector, rgba32f) readonly uniform imageBuffer coarseVector;
layout(binding = kBindingCoarseCentres, rgba32i) readonly uniform iimageBuffer coarseCentres;
layout(binding = kBindingLevers, rgba32i) readonly uniform iimageBuffer levers;
// One buffer twice: loads of texels are the faster ones.
layout(binding = kBindingFineVector, rgba32f) readonly uniform imageBuffer fineVector;
layout(std430, binding = kBindingFineResult) writeonly buffer FineResult { vec4 fineResult[]; };

void main() {
  ivec2 p = pointOf(push.firstRow);
  if (!hasPoint(push.fineSize, p)) {
    return;
  }
  int point = fineIndex(p);
  ivec4 lever = imageLoad(levers, point);
  Motion x = MOTION_AT(fineVector, point);
  [[unroll]] for (int v = 0; v < 2; ++v) {
    [[unroll]] for (int u = 0; u < 2; ++u) {
      ivec2 coarse = firstCoarse(p) + ivec2(u, v);
      int index = coarseIndex(coarse);
      Motion c = MOTION_AT(coarseVector, index);
      vec3 y = leverBetween(imageLoad(coarseCentres, index), lever);
      float share = shareOf(p, coarse);
      x.t += share * (c.t + cross(c.w, y));
      x.w += share * c.w;
    }
  }
  STORE_MOTION(fineResult, writtenIndex(push.fineSize), x);
}
