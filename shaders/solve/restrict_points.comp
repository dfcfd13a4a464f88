// The transpose of prolong_points.comp: a coarse point gets the forces and torques of the fine points
// around it.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "shared/multigrid_types.h"
#include "solve/block.glsl"
#include "solve/point_rows.glsl"
#include "solve/transfer.glsl"

layout(local_size_x_id = kConstantSubgroupSize) in;

layout(binding = kBindingFineVector, rgba32f) readonly uniform imageBuffer fineVector;
layout(binding = kBindingCoarseCentres, rgba32i) readonly uniform iimageBuffer coarseCentres;
layout(binding = kBindingLevers, rgba32i) readonly uniform iimageBuffer levers;
layout(std430, binding = kBindingResult) writeonly buffer Result { vec4 result[]; };

void main() {
  ivec2 coarse = pointOf(push.firstRow);
  if (!hasPoint(push.coarseSize, coarse)) {
    return;
  }
  ivec4 centre = imageLoad(coarseCentres, coarseIndex(coarse));
  Motion restricted = kNoMotion;
  [[unroll]] for (int v = -1; v <= 1; ++v) {
    [[unroll]] for (int u = -1; u <= 1; ++u) {
      ivec2 fine = finePointOf(coarse) + ivec2(u, v);
      int index = fineIndex(fine);
      Motion r = MOTION_AT(fineVector, index);
      vec3 lever = leverBetween(centre, imageLoad(levers, index));
      float share = shareOf(fine, coarse);
      restricted.t += share * r.t;
      restricted.w += share * (r.w + cross(lever, r.t));
    }
  }
  STORE_MOTION(result, writtenIndex(push.coarseSize), restricted);
}
