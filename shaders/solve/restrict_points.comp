// The transpose of prolong_points.comp: a coarse point gets the forces and torques of the fine points
// around it.
#version 450
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_control_flow_attributes : require
#include "shared/multigrid_types.h"
#include "solve/interpolation.glsl"
#include "solve/point_rows.glsl"

layout(local_size_x_id = kConstantSubgroupSize) in;

layout(binding = kBindingFineVector, rgba32f) readonly uniform imageBuffer fineVector;
layout(std430, binding = kBindingResult) writeonly buffer Result { vec4 result[]; };

void main() {
  ivec2 coarse = pointOf(push.firstRow);
  if (!hasPoint(push.coarseSize, coarse)) {
    return;
  }
  Motion total = kNoMotion;
  [[unroll]] for (int v = -1; v <= 1; ++v) {
    [[unroll]] for (int u = -1; u <= 1; ++u) {
      ivec2 fine = finePointOf(coarse) + ivec2(u, v);
      total = sum(total, restricted(interpolationOf(fine, coarse), MOTION_AT(fineVector, fineIndex(fine))));
    }
  }
  STORE_MOTION(result, writtenIndex(push.coarseSize), total);
}
